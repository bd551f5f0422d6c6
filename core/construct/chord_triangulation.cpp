// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/chord_triangulation.h"

#include <limits>
#include <vector>

namespace foldless {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

/// The best triangulation of what every chord cuts off.
class ChordTable {
 public:
  ChordTable(int corners, const PieceCost& cost)
      : cost_(Eigen::MatrixXd::Constant(corners, corners, kNone)),
        apex_(Eigen::MatrixXi::Constant(corners, corners, -1)) {
    for (int i = 0; i + 1 < corners; ++i) cost_(i, i + 1) = 0;
    for (int length = 2; length < corners; ++length)
      for (int i = 0; i + length < corners; ++i) fill(i, i + length, cost);
  }

  bool has_triangulation() const { return cost_(0, cost_.cols() - 1) < kNone; }

  Triangles triangles() const {
    const int corners = static_cast<int>(cost_.cols());
    Triangles result(3, corners - 2);
    Eigen::Index count = 0;
    for (std::vector<Edge> chords{{0, corners - 1}}; !chords.empty();) {
      const auto [i, k] = chords.back();
      chords.pop_back();
      if (k - i < 2) continue;
      const int j = apex_(i, k);
      result.col(count++) << i, j, k;
      chords.push_back({i, j});
      chords.push_back({j, k});
    }
    return result;
  }

 private:
  void fill(int i, int k, const PieceCost& cost) {
    for (int j = i + 1; j < k; ++j) {
      const double parts = cost_(i, j) + cost_(j, k);
      if (!(parts < cost_(i, k))) continue;
      const double whole = parts + cost(i, j, k);
      if (!(whole < cost_(i, k))) continue;
      cost_(i, k) = whole;
      apex_(i, k) = j;
    }
  }

  Eigen::MatrixXd cost_;  ///< n × n, above the diagonal
  Eigen::MatrixXi apex_;  ///< of the triangle at the chord
};

}  // namespace

std::optional<Triangles> triangulate_by_chords(int corners, const PieceCost& cost) {
  const ChordTable table(corners, cost);
  if (!table.has_triangulation()) return std::nullopt;
  return table.triangles();
}

}  // namespace foldless
