// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace foldless {

/// Sees to it that a write which fails can be told: a file that may not grow is an error and no end
/// of the program, and no file that is opened takes the number of a standard stream that is closed.
void prepare_streams();

/// Throws Error when something that was printed on stdout has not arrived.
void expect_output_arrived();

}  // namespace foldless
