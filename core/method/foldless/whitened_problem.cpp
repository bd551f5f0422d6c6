// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/whitened_problem.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <utility>

#include "core/mesh/injective.h"
#include "core/method/satisfied.h"

namespace foldless {
namespace whitening {

/// Of the standard deviations of the area along its two principal axes, from which it pays.
constexpr double kLeastAnisotropy = 20;

/// ∫ (x − c)(x − c)ᵀ dA about the centroid c. [length⁴]
Mat2 second_moments(const MeshPair& mesh) {
  double area = 0;
  Vec2 first = Vec2::Zero();
  Mat2 second = Mat2::Zero();
  for (const auto& t : mesh.triangles().colwise()) {
    const double A = signed_area(mesh.rest(), t);
    const Points corners = mesh.rest()(Eigen::all, t);
    const Vec2 sum = corners.rowwise().sum();
    area += A;
    first += A / 3 * sum;
    second += A / 12 * (corners * corners.transpose() + sum * sum.transpose());
  }
  return second - first * first.transpose() / area;
}

}  // namespace whitening

std::optional<WhitenedProblem> whitened_problem(const Problem& problem) {
  using namespace whitening;
  Eigen::SelfAdjointEigenSolver<Mat2> eigen;
  eigen.computeDirect(second_moments(problem.mesh));
  const Vec2 deviation = eigen.eigenvalues().cwiseMax(0).cwiseSqrt();
  if (!(deviation[0] > 0) || deviation[1] < kLeastAnisotropy * deviation[0]) return std::nullopt;
  Mat2 map = eigen.eigenvectors() * deviation.cwiseInverse().asDiagonal() *
             eigen.eigenvectors().transpose();
  map *=
      bounding_box_diagonal(problem.mesh.rest()) / bounding_box_diagonal(map * problem.mesh.rest());
  MeshPair mesh(problem.mesh.triangles(), map * problem.mesh.rest(), map * problem.mesh.deformed());
  if (!is_injective(mesh.triangles(), mesh.rest(), mesh.deformed())) return std::nullopt;
  WhitenedProblem whitened{{std::move(mesh), problem.energy, problem.handles, problem.parameters,
                            problem.original, map * problem.offset},
                           map};
  for (Handle& handle : whitened.problem.handles) handle.target = map * handle.target;
  return whitened;
}

std::optional<MeshPair> without_whitening(const MeshPair& whitened, const Mat2& map,
                                          const Problem& original) {
  const Mat2 inverse = map.inverse();
  Points rest = inverse * whitened.rest();
  rest.leftCols(original.mesh.vertex_count()) = original.mesh.rest();
  Points deformed = inverse * whitened.deformed();
  for (const Handle& handle : original.handles)
    if (handle.kind != HandleKind::soft) deformed.col(handle.vertex) = handle.target;
  if (!is_injective(whitened.triangles(), rest, deformed)) return std::nullopt;
  return MeshPair(whitened.triangles(), std::move(rest), std::move(deformed));
}

}  // namespace foldless
