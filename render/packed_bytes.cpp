// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/packed_bytes.h"

#include <zlib.h>

#include "core/error.h"

namespace foldless {

std::string packed(const std::vector<std::uint8_t>& bytes) {
  std::string result(compressBound(bytes.size()), '\0');
  uLongf size = result.size();
  if (compress2(reinterpret_cast<Bytef*>(result.data()), &size, bytes.data(), bytes.size(),
                Z_BEST_SPEED) != Z_OK)
    throw Error("not enough memory for the pictures");
  result.resize(size);
  result.shrink_to_fit();
  return result;
}

std::vector<std::uint8_t> unpacked(const std::string& packed, std::size_t count) {
  std::vector<std::uint8_t> result(count);
  uLongf size = count;
  if (uncompress(result.data(), &size, reinterpret_cast<const Bytef*>(packed.data()),
                 packed.size()) != Z_OK ||
      size != count)
    throw Error("not enough memory for the pictures");
  return result;
}

}  // namespace foldless
