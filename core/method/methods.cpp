// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/methods.h"

#include <algorithm>
#include <array>

#include "core/method/bounded_conformal.h"
#include "core/method/foldless/foldless.h"
#include "core/method/injective_projection.h"
#include "core/method/lim.h"
#include "core/method/remeshing_assisted.h"

namespace foldless {
namespace {

template <bool Flips, bool Splits>
std::unique_ptr<Method> start_remeshing_assisted(const Problem& problem) {
  return std::make_unique<RemeshingAssisted>(problem, Remeshing{.flips = Flips, .splits = Splits});
}

template <typename Kind>
std::unique_ptr<Method> start(const Problem& problem) {
  return std::make_unique<Kind>(problem);
}

using Names = std::string_view[];
constexpr Names kOfFoldless = {"beta", "delta", "eta", "condition_test"};
constexpr Names kOfAlgorithm1 = {"alpha",
                                 "beta",
                                 "delta",
                                 "eta",
                                 "inner_iterations",
                                 "outer_iterations",
                                 "gradient_tolerance",
                                 "step_tolerance",
                                 "condition_test",
                                 "area_weighted"};
constexpr Names kWithoutFlips = {"alpha",
                                 "beta",
                                 "delta",
                                 "inner_iterations",
                                 "outer_iterations",
                                 "gradient_tolerance",
                                 "step_tolerance",
                                 "area_weighted"};
constexpr Names kOfLim = {
    "alpha",          "beta",         "delta", "inner_iterations", "gradient_tolerance",
    "step_tolerance", "area_weighted"};
constexpr Names kOfBoundedConformal = {"alpha", "inner_iterations", "start", "distortion_bound"};
constexpr Names kOfProjection = {"alpha", "inner_iterations", "distortion_bound"};

constexpr std::array kMethods{
    MethodRow{"foldless", "Foldless", "this", start<Foldless>, false, false, kOfFoldless,
              Foldless::kBeta},
    MethodRow{"paper", "Remeshing-assisted, flips and splits", "JHT14",
              start_remeshing_assisted<true, true>, false, true, kOfAlgorithm1},
    MethodRow{"paper-flip", "Remeshing-assisted, flips", "JHT14",
              start_remeshing_assisted<true, false>, false, true, kOfAlgorithm1},
    MethodRow{"paper-noflip", "Remeshing-assisted, no flips", "JHT14",
              start_remeshing_assisted<false, false>, false, true, kWithoutFlips},
    MethodRow{"lim", "Locally injective mappings", "SKPSH13", start<Lim>, true, true, kOfLim},
    MethodRow{"bounded-conformal", "Bounded conformal distortion", "Lip12", start<BoundedConformal>,
              true, true, kOfBoundedConformal},
    MethodRow{"injective-projection", "Injective projection", "AL13", start<InjectiveProjection>,
              true, true, kOfProjection},
};

}  // namespace

std::span<const MethodRow> methods() { return kMethods; }

std::vector<std::string_view> method_names() {
  std::vector<std::string_view> names;
  names.reserve(std::size(kMethods));
  for (const MethodRow& row : kMethods) names.push_back(row.name);
  return names;
}

const MethodRow* find_method(std::string_view name) {
  const auto row = std::ranges::find(kMethods, name, &MethodRow::name);
  return row == kMethods.end() ? nullptr : &*row;
}

bool reads(const MethodRow& method, std::string_view parameter) {
  return std::ranges::find(method.parameters, parameter) != method.parameters.end();
}

double default_beta(std::string_view method, const Density& energy) {
  const MethodRow* row = find_method(method);
  return row ? row->beta.value_or(energy.default_beta) : energy.default_beta;
}

}  // namespace foldless
