// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/error.h"

/// What libFuzzer calls with every input; one a program.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace foldless::fuzz {

/// What a target finds wrong ends the program, which tells the fuzzer.
inline void expect(bool is_true, std::string_view what) {
  if (is_true) return;
  std::cerr << "not true: " << what << std::endl;
  std::abort();
}

/// Does the task; bad input may end in an Error of one line, and in nothing else.
template <typename Task>
void refuse_or_do(const Task& task) {
  try {
    task();
  } catch (const Error& error) {
    const std::string_view words = error.what();
    expect(!words.empty(), "an error says something");
    expect(words.find('\n') == words.npos, "an error is one line");
  }
}

/// The bytes of an input, taken from the front; zeros after the last.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : bytes_(data, size) {}

  bool is_empty() const { return bytes_.empty(); }
  std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const std::uint8_t first = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return first;
  }
  /// From 0 to below `end`, which is at most 65536.
  int below(int end) {
    const int high = byte();
    return (end > 256 ? 256 * high + byte() : high) % end;
  }
  /// From `least` to `most`, in 65536 steps.
  double between(double least, double most) {
    return least + (most - least) * below(65536) / 65535.0;
  }
  std::string_view rest() {
    const auto* begin = reinterpret_cast<const char*>(bytes_.data());
    return {begin, bytes_.size()};
  }
  std::span<const std::uint8_t> bytes() const { return bytes_; }

 private:
  std::span<const std::uint8_t> bytes_;
};

/// A file that is nowhere on a disk.
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view bytes) : descriptor_(::memfd_create("input", MFD_CLOEXEC)) {
    if (::write(descriptor_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
      throw std::runtime_error("no file in memory");
  }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

}  // namespace foldless::fuzz
