// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

namespace foldless {

/// The linear map P from values at the nodes of a coarse mesh to values at those of a fine one. A
/// value has two unknowns, 2i and 2i+1 of node i.
class Interpolation {
 public:
  /// A fine node has the sum of the values of three coarse ones times these weights; a weight 0
  /// takes none.
  struct Place {
    std::array<int, 3> nodes{};
    std::array<double, 3> weights{};
  };

  Interpolation(std::vector<Place> places, int coarse_nodes);

  int fine_nodes() const { return static_cast<int>(places_.size()); }
  int coarse_nodes() const { return static_cast<int>(start_.size()) - 1; }
  /// fine += P coarse.
  void add(const Eigen::VectorXd& coarse, Eigen::VectorXd& fine) const;
  /// Pᵀ fine.
  Eigen::VectorXd restricted(const Eigen::VectorXd& fine) const;

 private:
  /// What a coarse node gives to a fine one.
  struct Share {
    int fine;
    double weight;
  };

  std::vector<Place> places_;
  std::vector<int> start_;     ///< #coarse nodes + 1: where the shares of a coarse node begin
  std::vector<Share> shares_;  ///< sorted by fine nodes, coarse node after coarse node
};

}  // namespace foldless
