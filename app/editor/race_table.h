// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/editor/race.h"

namespace foldless {

/// The convergence information of the paper's Table 1: `G` gradient, `S` step, `M` not converged;
/// `–` while the lane runs or when it failed.
std::string_view convergence_letter(const RaceLane& lane);

/// The place of each lane that is at its end with every handle at its target and a map that does
/// not fold, by seconds of processor time; nothing for the others.
std::vector<std::optional<int>> race_places(const Race& race);

/// A row a lane, of the states that are shown: mesh and energy, method, δ, η, largest and mean
/// conformal distortion, ‖P‖², convergence, H, U, seconds, flips, splits, inverted triangles.
/// As the paper's Table 1.
std::string race_table_csv(const Race& race);

/// The same table for papers, numbers to three digits; see latex_table().
std::string race_table_latex(const Race& race);

/// Whether a table of that name is LaTeX; else it is CSV. Throws Error on other endings.
bool is_latex_table(const std::filesystem::path& file);

/// A row an iteration and lane, up to the furthest tick: the lane's title and the columns of
/// iterations.csv.
std::string race_records_csv(const Race& race);

}  // namespace foldless
