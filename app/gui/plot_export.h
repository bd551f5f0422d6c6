// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "app/editor/editor.h"

namespace foldless {

/// Every iteration as CSV: of the race while there is one, or else those since the last edit.
std::string convergence_csv(const Editor& editor);

/// Their convergence as SVG, a plot for each series that is switched on (by its index in
/// convergence_series()), two a row; curves of a race lie over each other.
std::string convergence_svg(const Editor& editor, std::span<const bool> shown);

}  // namespace foldless
