// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/convergence.h"

#include <algorithm>
#include <array>

namespace foldless {
namespace {

template <auto Member>
double state(const std::vector<Iteration>& iterations, std::size_t index) {
  return static_cast<double>(iterations[index].*Member);
}

/// What a total grew by; a smaller total belongs to a run that has begun anew.
template <auto Member>
double growth(const std::vector<Iteration>& iterations, std::size_t index) {
  const auto now = static_cast<double>(iterations[index].*Member);
  const double before = index == 0 ? 0.0 : static_cast<double>(iterations[index - 1].*Member);
  return now >= before ? now - before : now;
}

double milliseconds(const std::vector<Iteration>& iterations, std::size_t index) {
  return 1000 * growth<&Iteration::seconds>(iterations, index);
}

constexpr std::array kSeries{
    ConvergenceSeries{"energy", "Energy E", true, state<&Iteration::energy>},
    ConvergenceSeries{"gradient", "Gradient ‖∇E‖²", true, state<&Iteration::gradient_norm_squared>},
    ConvergenceSeries{"residual", "Distance to targets ‖P‖²", true,
                      state<&Iteration::handle_error_squared>},
    ConvergenceSeries{"distortion", "Largest distortion σ₁/σ₂", true,
                      state<&Iteration::max_conformal_distortion>},
    ConvergenceSeries{"area", "Smallest area ratio A′/A", true, state<&Iteration::min_area_ratio>},
    ConvergenceSeries{"time", "Milliseconds", true, milliseconds},
    ConvergenceSeries{"flips", "Flips", false, growth<&Iteration::flips>},
    ConvergenceSeries{"splits", "Splits", false, growth<&Iteration::splits>},
};

}  // namespace

std::span<const ConvergenceSeries> convergence_series() { return kSeries; }

int remeshed_edges(const std::vector<Iteration>& iterations, std::size_t index) {
  return static_cast<int>(growth<&Iteration::flips>(iterations, index) +
                          growth<&Iteration::splits>(iterations, index));
}

std::vector<double> times_of(const std::vector<Iteration>& iterations, std::size_t count) {
  std::vector<double> times;
  for (std::size_t i = 0; i < std::min(count, iterations.size()); ++i)
    times.push_back(iterations[i].seconds);
  return times;
}

std::vector<double> values_of(const ConvergenceSeries& series,
                              const std::vector<Iteration>& iterations, std::size_t count) {
  std::vector<double> values(std::min(count, iterations.size()));
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = series.value(iterations, i);
  return values;
}

}  // namespace foldless
