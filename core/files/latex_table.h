// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace foldless {

/// A text as LaTeX prints it, for pdflatex too: what has a meaning there is escaped, and of other
/// alphabets there are the signs of our tables: δ η ∇ ‖ ² – —.
std::string latex_text(std::string_view text);

/// Rows of cells under a row of titles as a `tabular` with the rules of the package booktabs.
/// Columns of numbers stand to the right, and `1.4e-14` becomes a power of ten. Precondition: every
/// row has as many cells as there are titles.
std::string latex_table(const std::vector<std::vector<std::string>>& rows);

}  // namespace foldless
