// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "core/iteration.h"

namespace foldless {

/// A quantity over the iterations, as it is plotted.
struct ConvergenceSeries {
  std::string_view name;   ///< one word
  std::string_view title;  ///< words and the paper's letter
  bool is_logarithmic;     ///< what its axis is
  /// The value of iteration `index`; counters and time as against the iteration before.
  double (*value)(const std::vector<Iteration>& iterations, std::size_t index);
};

/// Energy, ‖∇E‖², ‖P‖², largest distortion, smallest area ratio, milliseconds, flips, splits.
std::span<const ConvergenceSeries> convergence_series();

/// How many edges an iteration flipped or split.
int remeshed_edges(const std::vector<Iteration>& iterations, std::size_t index);

/// Seconds of processor time from the start to the end of each of the first `count` iterations.
std::vector<double> times_of(const std::vector<Iteration>& iterations, std::size_t count);

/// The values of the first `count` iterations.
std::vector<double> values_of(const ConvergenceSeries& series,
                              const std::vector<Iteration>& iterations, std::size_t count);

}  // namespace foldless
