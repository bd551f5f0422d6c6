// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/map_interpolation.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <queue>
#include <utility>

namespace foldless {
namespace interpolation {

Mat2 rotation(double angle) { return Eigen::Rotation2Dd(angle).toRotationMatrix(); }

/// Of angles that differ by full turns, the one nearest to another.
double nearest_to(double other, double angle) {
  constexpr double kTurn = 2 * std::numbers::pi;
  return angle + kTurn * std::round((other - angle) / kTurn);
}

}  // namespace interpolation

MapInterpolation::MapInterpolation(const MeshPair& mesh, const Constraints& constraints, Points to)
    : mesh_(mesh), to_(std::move(to)) {
  part_changes();
  turn_with_neighbours();
  number_free_vertices(constraints);
  gather_elements();
  factorize();
}

void MapInterpolation::part_changes() {
  changes_.reserve(static_cast<std::size_t>(mesh_.face_count()));
  for (const auto& t : mesh_.triangles().colwise()) {
    const Mat2 from = deformation_gradient(mesh_.rest(), mesh_.deformed(), t);
    const Mat2 change = deformation_gradient(mesh_.rest(), to_, t) * from.inverse();
    const double angle = std::atan2(change(1, 0) - change(0, 1), change(0, 0) + change(1, 1));
    changes_.push_back({from, angle, interpolation::rotation(-angle) * change});
  }
}

void MapInterpolation::turn_with_neighbours() {
  std::vector<bool> is_done(changes_.size(), false);
  for (std::size_t start = 0; start < changes_.size(); ++start) {
    if (is_done[start]) continue;
    is_done[start] = true;
    std::queue<int> queue({static_cast<int>(start)});
    for (; !queue.empty(); queue.pop()) {
      const double angle = changes_[static_cast<std::size_t>(queue.front())].angle;
      for (const int edge : mesh_.edges_of_triangle(queue.front()))
        for (const int next : mesh_.triangles_of_edge(edge)) {
          const auto t = static_cast<std::size_t>(next);
          if (is_done[t]) continue;
          changes_[t].angle = interpolation::nearest_to(angle, changes_[t].angle);
          is_done[t] = true;
          queue.push(next);
        }
    }
  }
}

void MapInterpolation::number_free_vertices(const Constraints& constraints) {
  node_of_.assign(static_cast<std::size_t>(mesh_.vertex_count()), 0);
  for (std::size_t i = 0; i < constraints.vertices.size(); ++i)
    if (!constraints.soft[i]) node_of_[static_cast<std::size_t>(constraints.vertices[i])] = -1;
  for (int v = 0; v < mesh_.vertex_count(); ++v)
    if (mesh_.is_isolated(v)) node_of_[static_cast<std::size_t>(v)] = -1;
  for (int& node : node_of_)
    if (node == 0) node = nodes_++;
}

void MapInterpolation::gather_elements() {
  elements_.reserve(static_cast<std::size_t>(mesh_.face_count()));
  for (const auto& t : mesh_.triangles().colwise()) {
    Element element;
    for (Eigen::Index i = 0; i < 3; ++i)
      element.nodes[static_cast<std::size_t>(i)] = node_of_[static_cast<std::size_t>(t[i])];
    element.area = signed_area(mesh_.rest(), t);
    element.hats = hat_gradients(mesh_.rest().col(t[0]), mesh_.rest().col(t[1]),
                                 mesh_.rest().col(t[2]), element.area);
    elements_.push_back(element);
  }
}

void MapInterpolation::factorize() {
  std::vector<std::pair<int, int>> edges;
  for (const Element& element : elements_)
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = element.nodes[i], b = element.nodes[(i + 1) % 3];
      if (a >= 0 && b >= 0) edges.emplace_back(a, b);
    }
  SparseSymmetric matrix = sparse_symmetric(nodes_, edges);
  for (const Element& element : elements_) {
    const Eigen::Matrix3d weights = element.area * element.hats.transpose() * element.hats;
    Eigen::Matrix<double, 6, 6> block;
    for (Eigen::Index i = 0; i < 3; ++i)
      for (Eigen::Index j = 0; j < 3; ++j)
        block.block<2, 2>(2 * i, 2 * j) = weights(i, j) * Mat2::Identity();
    add_block(matrix, element.nodes, block);
  }
  cholesky_.analyze(matrix);
  cholesky_.factorize(matrix);
}

Mat2 MapInterpolation::gradient_at(const Change& change, double t) const {
  return interpolation::rotation(t * change.angle) *
         ((1 - t) * Mat2::Identity() + t * change.stretch) * change.from;
}

Points MapInterpolation::at(double t) {
  Points points = to_;
  if (t >= 1) return points;
  Eigen::VectorXd side = Eigen::VectorXd::Zero(2 * Eigen::Index{nodes_});
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    const auto& [nodes, hats, area] = elements_[k];
    const Eigen::Vector3i corners = mesh_.triangles().col(static_cast<Eigen::Index>(k));
    Mat2 wanted = gradient_at(changes_[k], t);
    for (Eigen::Index i = 0; i < 3; ++i)
      if (nodes[static_cast<std::size_t>(i)] < 0)
        wanted -= to_.col(corners[i]) * hats.col(i).transpose();
    for (Eigen::Index i = 0; i < 3; ++i) {
      const int node = nodes[static_cast<std::size_t>(i)];
      if (node >= 0) side.segment<2>(2 * Eigen::Index{node}) += area * wanted * hats.col(i);
    }
  }
  const Eigen::VectorXd solved = cholesky_.solve(side);
  for (std::size_t v = 0; v < node_of_.size(); ++v)
    if (node_of_[v] >= 0)
      points.col(static_cast<Eigen::Index>(v)) = solved.segment<2>(2 * Eigen::Index{node_of_[v]});
  return points;
}

}  // namespace foldless
