// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/iteration.h"

namespace foldless {

/// The column names of iterations.csv, with commas between them.
std::string iteration_columns();

/// Adds the fields of one record in that order, with commas between them.
void append_iteration(std::string& text, const Iteration& record);

/// The text of iterations.csv: a line of column names, and one a record. E_c and E_b are weighted,
/// so that E_d + E_c + E_b = E.
std::string iterations_csv(const std::vector<Iteration>& iterations);

}  // namespace foldless
