// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace foldless {

// Exit statuses of every call.

inline constexpr int kExitDone = 0;          ///< done, and every handle satisfied
inline constexpr int kExitNotSatisfied = 1;  ///< ran to its end, but not so; results are written
/// Bad input or usage, and nothing was written; or what was printed did not arrive.
inline constexpr int kExitBadInput = 2;
inline constexpr int kExitInterrupted = 130;  ///< interrupted; the last valid mesh is kept

}  // namespace foldless
