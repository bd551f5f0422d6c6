// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/png_rows.h"

#include <zlib.h>

#include <array>
#include <cstdlib>
#include <limits>
#include <string_view>

#include "core/error.h"
#include "render/png_chunks.h"

namespace foldless {
namespace {

constexpr int kPixel = 4;  ///< bytes
constexpr int kFilters = 5;
constexpr int kWindowBits = 15, kMemoryLevel = 8;  ///< what zlib takes by itself

void append_u32(std::string& bytes, int value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xFF);
}

/// What the fourth filter of PNG foretells: of left, above and above left the nearest to a + b − c.
int paeth(int a, int b, int c) {
  const int to_a = std::abs(b - c), to_b = std::abs(a - c), to_c = std::abs(a + b - 2 * c);
  if (to_a <= to_b && to_a <= to_c) return a;
  return to_b <= to_c ? b : c;
}

int foretold(int filter, int left, int above, int above_left) {
  switch (filter) {
    case 1: return left;
    case 2: return above;
    case 3: return (left + above) / 2;
    case 4: return paeth(left, above, above_left);
    default: return 0;
  }
}

/// A filter's number, and the differences to what it foretells.
std::vector<std::uint8_t> filtered(int filter, const std::vector<std::uint8_t>& row,
                                   const std::vector<std::uint8_t>& above) {
  std::vector<std::uint8_t> line{static_cast<std::uint8_t>(filter)};
  line.reserve(row.size() + 1);
  for (std::size_t i = 0; i < row.size(); ++i) {
    const int left = i < kPixel ? 0 : row[i - kPixel];
    const int above_left = i < kPixel ? 0 : above[i - kPixel];
    line.push_back(
        static_cast<std::uint8_t>(row[i] - foretold(filter, left, above[i], above_left)));
  }
  return line;
}

/// The smaller, the better a line can be packed, as a rule.
long size_of_differences(const std::vector<std::uint8_t>& line) {
  long sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += std::abs(static_cast<std::int8_t>(line[i]));
  return sum;
}

}  // namespace

struct PngRows::Deflater {
  Deflater() {
    if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kWindowBits, kMemoryLevel,
                     Z_FILTERED) != Z_OK)
      throw Error("not enough memory for the picture");
  }
  ~Deflater() { deflateEnd(&stream); }
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;

  z_stream stream{};
};

PngRows::PngRows(int width, int height, const ImageTexts& texts)
    : file_(kPngSignature),
      above_(static_cast<std::size_t>(width) * kPixel),
      deflater_(std::make_unique<Deflater>()) {
  std::string header;
  append_u32(header, width);
  append_u32(header, height);
  header += std::string_view("\x08\x06\0\0\0", 5);  // 8 bits, RGBA, not interlaced
  file_ += png_chunk({"IHDR", header});
  for (const auto& [keyword, text] : texts) file_ += png_text_chunk(keyword, text);
}

PngRows::~PngRows() = default;

void PngRows::add(const std::vector<std::uint8_t>& row) {
  std::vector<std::uint8_t> best;
  long least = std::numeric_limits<long>::max();
  for (int filter = 0; filter < kFilters; ++filter) {
    std::vector<std::uint8_t> line = filtered(filter, row, above_);
    const long size = size_of_differences(line);
    if (size >= least) continue;
    least = size;
    best = std::move(line);
  }
  deflate_line(best, false);
  above_ = row;
}

std::string PngRows::finish() {
  deflate_line({}, true);
  file_ += png_chunk({"IEND", ""});
  return std::move(file_);
}

void PngRows::deflate_line(const std::vector<std::uint8_t>& line, bool is_last) {
  z_stream& stream = deflater_->stream;
  // zlib does not write to it.
  stream.next_in = const_cast<Bytef*>(line.data());
  stream.avail_in = static_cast<uInt>(line.size());
  std::array<char, 1 << 15> block{};
  do {
    stream.next_out = reinterpret_cast<Bytef*>(block.data());
    stream.avail_out = block.size();
    deflate(&stream, is_last ? Z_FINISH : Z_NO_FLUSH);
    const std::size_t made = block.size() - stream.avail_out;
    if (made > 0) file_ += png_chunk({"IDAT", {block.data(), made}});
  } while (stream.avail_out == 0);
}

}  // namespace foldless
