// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/failing_allocation.h"

#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>

namespace foldless::test {
namespace {

constexpr long kNever = std::numeric_limits<long>::max();

std::atomic<long> left = kNever;
/// The thread that has the test, which goes on.
thread_local bool is_spared = false;

bool fails() { return !is_spared && left.load() != kNever && left.fetch_sub(1) == 1; }

}  // namespace

FailingAllocation::FailingAllocation(long n) {
  is_spared = true;
  left = n;
}
FailingAllocation::~FailingAllocation() { left = kNever; }
bool FailingAllocation::has_happened() const { return left < 1; }

}  // namespace foldless::test

// The names of what is stood in for.
void* operator new(std::size_t size) {
  if (foldless::test::fails()) throw std::bad_alloc();
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
void* operator new[](std::size_t size) { return operator new(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
