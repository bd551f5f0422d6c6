// SPDX-License-Identifier: GPL-3.0-or-later
// Who asks for memory, as the stack tells.
#pragma once

namespace foldless::test {

/// To be called before the program loads more libraries.
void find_objects();
/// Whether the memory is asked for by the program, perhaps through the standard library.
bool is_asked_by_program();
/// Whether the same calls have not led here before.
bool is_new_place();

}  // namespace foldless::test
