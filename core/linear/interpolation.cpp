// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/interpolation.h"

#include <utility>

#include "core/threads/team.h"

namespace foldless {
namespace {

/// Nodes of which a thread makes the values together.
constexpr std::ptrdiff_t kInterpolatedTogether = 1024;

}  // namespace

Interpolation::Interpolation(std::vector<Place> places, int coarse_nodes)
    : places_(std::move(places)), start_(static_cast<std::size_t>(coarse_nodes) + 1, 0) {
  const auto each_share = [this](const auto& visit) {
    for (std::size_t i = 0; i < places_.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k)
        if (places_[i].weights[k] != 0)
          visit(static_cast<std::size_t>(places_[i].nodes[k]),
                Share{static_cast<int>(i), places_[i].weights[k]});
  };
  each_share([this](std::size_t node, const Share&) { ++start_[node + 1]; });
  for (std::size_t node = 1; node < start_.size(); ++node) start_[node] += start_[node - 1];
  shares_.resize(static_cast<std::size_t>(start_.back()));
  std::vector<int> next(start_.begin(), start_.end() - 1);
  each_share([&](std::size_t node, const Share& share) {
    shares_[static_cast<std::size_t>(next[node]++)] = share;
  });
}

void Interpolation::add(const Eigen::VectorXd& coarse, Eigen::VectorXd& fine) const {
  each_in_ranges(fine_nodes(), kInterpolatedTogether, [&](std::ptrdiff_t i) {
    const Place& place = places_[static_cast<std::size_t>(i)];
    for (std::size_t k = 0; k < 3; ++k)
      if (place.weights[k] != 0)
        fine.segment<2>(2 * i) += place.weights[k] * coarse.segment<2>(2 * place.nodes[k]);
  });
}

// By coarse nodes, so that a sum has one order however many threads there are.
Eigen::VectorXd Interpolation::restricted(const Eigen::VectorXd& fine) const {
  Eigen::VectorXd coarse(2 * coarse_nodes());
  each_in_ranges(coarse_nodes(), kInterpolatedTogether, [&](std::ptrdiff_t node) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    const auto of = static_cast<std::size_t>(node);
    for (int k = start_[of]; k < start_[of + 1]; ++k) {
      const Share& share = shares_[static_cast<std::size_t>(k)];
      sum += share.weight * fine.segment<2>(2 * share.fine);
    }
    coarse.segment<2>(2 * node) = sum;
  });
  return coarse;
}

}  // namespace foldless
