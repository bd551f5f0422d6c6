// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/threads/used_memory.h"

#include <array>
#include <new>
#include <span>

#if defined(__SANITIZE_ADDRESS__)
#define FOLDLESS_ADDRESS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define FOLDLESS_ADDRESS_SANITIZER
#endif
#endif

#ifdef FOLDLESS_ADDRESS_SANITIZER
#include <sanitizer/asan_interface.h>
#else
#define ASAN_POISON_MEMORY_REGION(memory, bytes) static_cast<void>(0)
#define ASAN_UNPOISON_MEMORY_REGION(memory, bytes) static_cast<void>(0)
#endif

namespace foldless {
namespace {

/// Smaller blocks come from pages that are in use anyway, larger ones would hold too much.
constexpr std::size_t kLeastKept = std::size_t{8} << 10;
constexpr std::size_t kMostKept = std::size_t{16} << 20;
/// Of one thread.
constexpr std::size_t kMostKeptInAll = std::size_t{32} << 20;
constexpr std::size_t kMostBlocks = 64;
/// A block serves for no less than this part of it.
constexpr std::size_t kLeastPart = 4;

/// What is before the memory that is given out.
struct alignas(__STDCPP_DEFAULT_NEW_ALIGNMENT__) Block {
  std::size_t bytes;  ///< behind it

  void* memory() { return this + 1; }
};

Block* new_block(std::size_t bytes) {
  return ::new (::operator new(sizeof(Block) + bytes)) Block{bytes};
}

void delete_block(Block* block) { ::operator delete(block); }

/// What lives as long as a thread may give memory back after its blocks are gone.
thread_local bool has_thread_ended = false;

/// The blocks that a thread keeps.
class KeptBlocks {
 public:
  KeptBlocks() = default;
  KeptBlocks(const KeptBlocks&) = delete;
  KeptBlocks& operator=(const KeptBlocks&) = delete;
  ~KeptBlocks() {
    for (Block* block : all()) delete_block(block);
    has_thread_ended = true;
  }

  /// The smallest that serves; null where none does.
  Block* take(std::size_t bytes) {
    Block** best = nullptr;
    for (Block*& block : all())
      if (block->bytes >= bytes && block->bytes <= kLeastPart * bytes &&
          (!best || block->bytes < (*best)->bytes))
        best = &block;
    if (!best) return nullptr;
    Block* block = *best;
    *best = blocks_[--count_];
    bytes_ -= block->bytes;
    ASAN_UNPOISON_MEMORY_REGION(block->memory(), bytes);
    return block;
  }

  bool keep(Block* block) {
    if (count_ == kMostBlocks || bytes_ + block->bytes > kMostKeptInAll) return false;
    blocks_[count_++] = block;
    bytes_ += block->bytes;
    ASAN_POISON_MEMORY_REGION(block->memory(), block->bytes);
    return true;
  }

 private:
  std::span<Block*> all() { return std::span(blocks_).first(count_); }

  std::array<Block*, kMostBlocks> blocks_{};
  std::size_t count_ = 0, bytes_ = 0;
};

/// Null where a block of so many bytes is not kept.
KeptBlocks* kept_blocks(std::size_t bytes) {
  if (has_thread_ended || bytes < kLeastKept || bytes > kMostKept) return nullptr;
  thread_local KeptBlocks blocks;
  return &blocks;
}

}  // namespace

void* take_memory(std::size_t bytes) {
  KeptBlocks* kept = kept_blocks(bytes);
  Block* block = kept ? kept->take(bytes) : nullptr;
  if (!block) block = new_block(bytes);
  return block->memory();
}

void give_back_memory(void* memory) noexcept {
  if (!memory) return;
  Block* block = static_cast<Block*>(memory) - 1;
  KeptBlocks* kept = kept_blocks(block->bytes);
  if (!kept || !kept->keep(block)) delete_block(block);
}

}  // namespace foldless
