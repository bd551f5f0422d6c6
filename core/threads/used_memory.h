// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace foldless {

/// Memory for so many bytes, aligned as by new, if possible some that this thread has used before:
/// what is used for the first time is a fault for every page of it, a fifth of the time in which a
/// small mesh is solved. Throws std::bad_alloc.
void* take_memory(std::size_t bytes);
/// Gives back what take_memory() gave, on any thread, which keeps up to 32 MiB for itself and,
/// where there is an address sanitizer, out of bounds.
void give_back_memory(void* memory) noexcept;

}  // namespace foldless
