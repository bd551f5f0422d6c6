// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/large_pages.h"

#include <sys/mman.h>

#include <cstdint>

namespace foldless {
namespace {

/// Of processors and systems that have others these are a multiple, or the advice is not taken.
constexpr std::size_t kLargePage = std::size_t{2} << 20;

}  // namespace

void ask_for_large_pages(void* memory, std::size_t bytes) {
  const std::size_t before =
      (kLargePage - reinterpret_cast<std::uintptr_t>(memory) % kLargePage) % kLargePage;
  if (bytes < before + kLargePage) return;
  const std::size_t whole = (bytes - before) / kLargePage * kLargePage;
  ::madvise(static_cast<char*>(memory) + before, whole, MADV_HUGEPAGE);
}

}  // namespace foldless
