// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/methods.h"

#include <algorithm>
#include <array>

#include "core/method/bounded_conformal.h"
#include "core/method/foldless.h"
#include "core/method/injective_projection.h"
#include "core/method/lim.h"
#include "core/method/remeshing_assisted.h"

namespace foldless {
namespace {

template <bool kFlips, bool kSplits>
std::unique_ptr<Method> start_remeshing_assisted(Problem problem) {
  return std::make_unique<RemeshingAssisted>(std::move(problem),
                                             Remeshing{.flips = kFlips, .splits = kSplits});
}

template <typename Kind>
std::unique_ptr<Method> start(Problem problem) {
  return std::make_unique<Kind>(std::move(problem));
}

constexpr std::array kMethods{
    MethodRow{"foldless", "Foldless", "this", start<Foldless>},
    MethodRow{"paper", "Remeshing-assisted, flips and splits", "JHT14",
              start_remeshing_assisted<true, true>},
    MethodRow{"paper-flip", "Remeshing-assisted, flips", "JHT14",
              start_remeshing_assisted<true, false>},
    MethodRow{"paper-noflip", "Remeshing-assisted, no flips", "JHT14",
              start_remeshing_assisted<false, false>},
    MethodRow{"lim", "Locally injective mappings", "SKPSH13", start<Lim>, true},
    MethodRow{"bounded-conformal", "Bounded conformal distortion", "Lip12", start<BoundedConformal>,
              true},
    MethodRow{"injective-projection", "Injective projection", "AL13", start<InjectiveProjection>,
              true},
};

}  // namespace

std::span<const MethodRow> methods() { return kMethods; }

const MethodRow* find_method(std::string_view name) {
  const auto row = std::ranges::find(kMethods, name, &MethodRow::name);
  return row == kMethods.end() ? nullptr : &*row;
}

}  // namespace foldless
