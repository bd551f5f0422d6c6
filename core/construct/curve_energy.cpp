// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/curve_energy.h"

#include <cstdint>
#include <unordered_map>

#include "core/construct/directed_edge.h"

namespace foldless {
namespace {

/// Cotangents of the angles opposite to directed edges, at rest.
std::unordered_map<std::uint64_t, double> cotangents(const TriangulatedDisk& disk) {
  std::unordered_map<std::uint64_t, double> cotangents;
  for (const Eigen::Vector3i& t : disk.triangles)
    for (int i = 0; i < 3; ++i) {
      const Vec2 a = disk.rest.col(t[i]), b = disk.rest.col(t[(i + 1) % 3]);
      const Vec2 c = disk.rest.col(t[(i + 2) % 3]);
      cotangents[directed_edge(t[i], t[(i + 1) % 3])] =
          (a - c).dot(b - c) / (2 * signed_area(a, b, c));
    }
  return cotangents;
}

}  // namespace

double length_of(const CarriedCurves::Curve& curve, const Points& deformed) {
  double length = 0;
  Vec2 at = deformed.col(curve.from);
  for (const Vec2 bend : curve.bends.colwise()) {
    length += (bend - at).norm();
    at = bend;
  }
  return length + (deformed.col(curve.to) - at).norm();
}

CurveEnergy::CurveEnergy(const TriangulatedDisk& disk) : disk_(disk) {
  const auto opposite = cotangents(disk);
  const CarriedCurves at_rest(disk.triangles, disk.rest);
  const std::vector<CarriedCurves::Curve> edges = at_rest.curves();
  weights_.reserve(edges.size());
  for (const CarriedCurves::Curve& curve : edges)
    weights_.push_back(opposite.at(directed_edge(curve.from, curve.to)) +
                       opposite.at(directed_edge(curve.to, curve.from)));
}

double CurveEnergy::operator()(const std::vector<CarriedCurves::Curve>& curves) const {
  double sum = 0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const double length = length_of(curves[i], disk_.deformed);
    sum += weights_[i] * length * length;
  }
  return sum / 4;
}

}  // namespace foldless
