// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "core/scene/parameters.h"

namespace foldless {

/// What the paper reports of a run; what it leaves out is absent.
struct PaperFigures {
  std::optional<double> max_distortion = {};
  std::optional<double> mean_distortion = {};
  std::optional<double> handle_error_squared = {};  ///< ‖P(u)‖²
  char convergence = 0;                    ///< `G` gradient, `S` step, `M` none; 0: not told
  std::optional<int> factorizations = {};  ///< H
  std::optional<int> updates = {};         ///< U
  std::optional<double> seconds = {};
};

/// One run of the reproduction: a row of Table 1 [JHT14] or of the comparisons of its section 5.
struct PaperRow {
  std::string_view scene;   ///< stem of its file in assets/scenes
  std::string_view label;   ///< the method as the paper calls it
  std::string_view method;  ///< a name that methods() may have
  double delta = 1e-5;
  std::optional<double> eta = {};  ///< absent: no flips
  PaperFigures paper = {};
  bool condition_test = true;  ///< eq. 10
  /// K of [Lip12] and [AL13]: as in the paper the largest distortion of our own result.
  std::optional<double> distortion_bound = {};
  StartFrames start = StartFrames::unconstrained;  ///< [Lip12]
};

/// All of them, scene by scene; those of the scenes of Table 1 in its order.
std::span<const PaperRow> paper_rows();

}  // namespace foldless
