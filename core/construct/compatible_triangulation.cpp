// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/compatible_triangulation.h"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/construct/chord_triangulation.h"
#include "core/construct/corner_order.h"
#include "core/construct/overlay.h"

namespace foldless {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
/// What a triangle that is no piece of the other polygon costs, in diagonals of chords: more than
/// all chords together, for it makes vertices.
constexpr double kNoPiece = 100;
/// What a sliver costs: corners on a line that rounding has bent make triangles of no use.
constexpr double kSliver = 1e6;
/// 4√3 area over the sum of the squared sides, 1 for an equilateral triangle, below which a
/// triangle is one.
constexpr double kLeastRoundness = 1e-3;

double cost_of_shape(const Points& polygon, int i, int j, int k) {
  const Vec2 a = polygon.col(i), b = polygon.col(j), c = polygon.col(k);
  const double sides = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return 4 * std::sqrt(3.0) * signed_area(a, b, c) < kLeastRoundness * sides ? kSliver : 0;
}

double diagonal_of(const Points& points) {
  return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
}

/// The two polygons.
class PolygonPair {
 public:
  PolygonPair(const Points& rest, const Points& deformed, StraightBack tips = StraightBack::none)
      : rest_(rest),
        deformed_(deformed),
        rest_order_(rest, tips),
        deformed_order_(deformed, tips),
        rest_unit_(1 / diagonal_of(rest)),
        deformed_unit_(1 / diagonal_of(deformed)) {}

  int corners() const { return rest_order_.corners(); }

  /// The shortest chords, of triangles that serve the rest polygon too where possible.
  std::optional<Triangles> deformed_triangles() const {
    return triangulate_by_chords(corners(), [this](int i, int j, int k) {
      if (!deformed_order_.is_piece(i, j, k)) return kNever;
      const double at_rest =
          rest_order_.is_piece(i, j, k) ? cost_of_shape(rest_, i, j, k) : kNoPiece;
      return length(i, k) + cost_of_shape(deformed_, i, j, k) + at_rest;
    });
  }
  /// The fewest crossings with the chords of the deformed polygon, then the shortest chords.
  std::optional<Triangles> rest_triangles(const Triangles& deformed) const {
    const std::vector<Edge> chords = chords_of(corners(), deformed);
    Eigen::MatrixXd cost(corners(), corners());
    for (int k = 0; k < corners(); ++k)
      for (int i = 0; i < k; ++i)
        cost(i, k) = length(i, k) + kNoPiece * crossings_of({i, k}, chords);
    return triangulate_by_chords(corners(), [&](int i, int j, int k) {
      return rest_order_.is_piece(i, j, k) ? cost(i, k) + cost_of_shape(rest_, i, j, k) : kNever;
    });
  }
  /// Triangles that serve both, or nothing.
  std::optional<Triangles> common_triangles() const {
    return triangulate_by_chords(corners(), [this](int i, int j, int k) {
      const bool serves = rest_order_.is_piece(i, j, k) && deformed_order_.is_piece(i, j, k);
      return serves
                 ? length(i, k) + cost_of_shape(rest_, i, j, k) + cost_of_shape(deformed_, i, j, k)
                 : kNever;
    });
  }

 private:
  /// Of a chord, in both.
  double length(int i, int k) const {
    return rest_unit_ * (rest_.col(i) - rest_.col(k)).norm() +
           deformed_unit_ * (deformed_.col(i) - deformed_.col(k)).norm();
  }

  const Points &rest_, &deformed_;
  CornerOrder rest_order_, deformed_order_;
  double rest_unit_, deformed_unit_;  ///< 1 / diagonals
};

Vec2 point_on(const Points& polygon, const ChordCrossing::Place& place) {
  const auto [a, b] = place.chord;
  return polygon.col(a) + place.t * (polygon.col(b) - polygon.col(a));
}

/// The corners, then the crossings of chords of the rest polygon with those of the deformed one.
Points with_crossings(const Points& polygon, const Overlay& overlay,
                      ChordCrossing::Place ChordCrossing::*chord) {
  Points points(2, polygon.cols() + static_cast<Eigen::Index>(overlay.crossings.size()));
  points.leftCols(polygon.cols()) = polygon;
  Eigen::Index next = polygon.cols();
  for (const ChordCrossing& crossing : overlay.crossings)
    points.col(next++) = point_on(polygon, crossing.*chord);
  return points;
}

std::optional<Triangles> triangles_of(const Overlay& overlay, const Points& rest,
                                      const Points& deformed) {
  std::vector<Eigen::Vector3i> triangles;
  for (const std::vector<int>& face : overlay.faces) {
    const auto pieces =
        PolygonPair(rest(Eigen::all, face), deformed(Eigen::all, face)).common_triangles();
    if (!pieces) return std::nullopt;
    for (const auto& piece : pieces->colwise())
      triangles.emplace_back(
          piece.unaryExpr([&](int corner) { return face[static_cast<std::size_t>(corner)]; }));
  }
  Triangles result(3, static_cast<Eigen::Index>(triangles.size()));
  for (Eigen::Index t = 0; t < result.cols(); ++t)
    result.col(t) = triangles[static_cast<std::size_t>(t)];
  return result;
}

struct TriangulatedPolygon {
  const Points& corners;
  Triangles triangles;  ///< i < j < k
};

std::optional<MeshPair> laid_over(const TriangulatedPolygon& rest,
                                  const TriangulatedPolygon& deformed) {
  const Overlay overlay =
      overlay_of(static_cast<int>(rest.corners.cols()), rest.triangles, deformed.triangles);
  Points all_rest = with_crossings(rest.corners, overlay, &ChordCrossing::first);
  Points all_deformed = with_crossings(deformed.corners, overlay, &ChordCrossing::second);
  const std::optional<Triangles> triangles = triangles_of(overlay, all_rest, all_deformed);
  if (!triangles) return std::nullopt;
  return MeshPair(*triangles, std::move(all_rest), std::move(all_deformed));
}

}  // namespace

bool bounds_disk(const Points& polygon) {
  const CornerOrder order(polygon);
  return triangulate_by_chords(
             order.corners(),
             [&](int i, int j, int k) { return order.is_piece(i, j, k) ? 0 : kNever; })
      .has_value();
}

std::optional<MeshPair> compatible_triangulation(const Points& rest, const Points& deformed) {
  const PolygonPair polygons(rest, deformed);
  const std::optional<Triangles> of_deformed = polygons.deformed_triangles();
  if (!of_deformed) return std::nullopt;
  const std::optional<Triangles> of_rest = polygons.rest_triangles(*of_deformed);
  if (!of_rest) return std::nullopt;
  return laid_over({rest, *of_rest}, {deformed, *of_deformed});
}

std::optional<MeshPair> compatible_triangulation(const SlitDisks& disks, int most_corners) {
  TriangulatedPolygon rest{disks.rest, disks.rest_triangles};
  TriangulatedPolygon deformed{disks.deformed, disks.deformed_triangles};
  if (disks.rest.cols() <= most_corners) {
    const PolygonPair polygons(disks.rest, disks.deformed, StraightBack::full_turn);
    if (const auto triangles = polygons.deformed_triangles()) deformed.triangles = *triangles;
    if (const auto triangles = polygons.rest_triangles(deformed.triangles))
      rest.triangles = *triangles;
  }
  if (rest.triangles.cols() == 0 || deformed.triangles.cols() == 0) return std::nullopt;
  return laid_over(rest, deformed);
}

}  // namespace foldless
