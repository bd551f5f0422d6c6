// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/objective.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foldless {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Smallest positive root of c + b t + a t² with c > 0, or infinity.
double smallest_positive_root(double a, double b, double c) {
  const double discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return kInfinity;
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  double root = kInfinity;
  for (const double t : {q / a, c / q})
    if (t > 0) root = std::min(root, t);  // NaN and division by zero fall through
  return root;
}

void add(const ElementEnergy& element, EnergyTerms& sum) {
  sum.distortion += element.distortion;
  sum.barrier += element.barrier;
}

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace

Objective::Objective(const EnergySettings& settings, const MeshPair& mesh,
                     const Positions& positions)
    : settings_(settings), unknowns_(unknowns_of(mesh, positions.vertices)) {
  is_handle_.assign(static_cast<std::size_t>(unknowns_.count()), false);
  for (int i = 0; i < positions.count(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    const int node = node_of(positions.vertices[row]);
    if (node >= 0 && !positions.soft[row]) is_handle_[static_cast<std::size_t>(node)] = true;
  }
  Eigen::Index moving = 0;
  for (const auto& t : mesh.triangles().colwise()) moving += node_of(t[0]) >= 0;
  triangles_ = Triangles::Constant(3, moving, -1);
  rest_.resize(static_cast<std::size_t>(moving));
  take_flips(mesh);
}

void Objective::take_flips(const MeshPair& mesh) {
  triangles_of_handles_.clear();
  Eigen::Index moving = 0;
  for (const auto& t : mesh.triangles().colwise()) {
    if (node_of(t[0]) < 0) continue;
    if (std::ranges::any_of(t, [&](int v) { return is_handle(node_of(v)); }))
      triangles_of_handles_.push_back(moving);
    if (triangles_.col(moving) != t) {
      triangles_.col(moving) = t;
      rest_[static_cast<std::size_t>(moving)] = rest_element(settings_, corners_of(mesh.rest(), t));
    }
    ++moving;
  }
}

EnergyTerms Objective::value(const Points& u, const Positions& positions) const {
  EnergyTerms terms;
  for (Eigen::Index t = 0; t < triangles_.cols(); ++t) {
    const ElementEnergy e = element_energy(settings_, rest_[static_cast<std::size_t>(t)],
                                           corners_of(u, triangles_.col(t)));
    if (e.barrier == kInfinity) return {0, 0, kInfinity};
    add(e, terms);
  }
  terms.penalty = settings_.alpha * penalty(positions, u);
  return terms;
}

EnergyGradient Objective::gradient(const Points& u, const Positions& positions) const {
  EnergyGradient sum{{}, Eigen::VectorXd::Zero(2 * unknowns_.count())};
  for (Eigen::Index t = 0; t < triangles_.cols(); ++t) {
    const ElementGradient e = element_gradient(settings_, rest_[static_cast<std::size_t>(t)],
                                               corners_of(u, triangles_.col(t)));
    add(e.energy, sum.energy);
    for (int corner = 0; corner < 3; ++corner)
      sum.gradient.segment<2>(2 * node_of(triangles_(corner, t))) +=
          e.gradient.segment<2>(2 * corner);
  }
  add_positions(u, positions, sum);
  return sum;
}

EnergyGradient Objective::assemble(const Points& u, const Positions& positions,
                                   SparseSymmetric& hessian, double clamping) const {
  EnergyGradient sum{{}, Eigen::VectorXd::Zero(2 * unknowns_.count())};
  std::fill(hessian.value.begin(), hessian.value.end(), 0.0);
  for (Eigen::Index t = 0; t < triangles_.cols(); ++t) {
    const ElementHessian e = element_hessian(settings_, rest_[static_cast<std::size_t>(t)],
                                             corners_of(u, triangles_.col(t)), clamping);
    add(e.energy, sum.energy);
    std::array<int, 3> nodes{};
    for (int corner = 0; corner < 3; ++corner) {
      const int node = node_of(triangles_(corner, t));
      const bool is_out = positions.held && is_handle(node);
      nodes[static_cast<std::size_t>(corner)] = is_out ? -1 : node;
      sum.gradient.segment<2>(2 * node) += e.gradient.segment<2>(2 * corner);
    }
    add_block(hessian, nodes, e.hessian);
  }
  add_positions(u, positions, sum);
  add_positions(positions, hessian);
  return sum;
}

Eigen::VectorXd Objective::pull_of_handles(const Points& u, const Points& way) const {
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(2 * unknowns_.count());
  for (const Eigen::Index t : triangles_of_handles_) {
    const auto& corners = triangles_.col(t);
    const Corners moves = corners_of(way, corners);
    if (moves.isZero(0)) continue;
    const ElementHessian e =
        element_hessian(settings_, rest_[static_cast<std::size_t>(t)], corners_of(u, corners), 1);
    const Eigen::Matrix<double, 6, 1> change = e.hessian * moves.reshaped();
    for (int corner = 0; corner < 3; ++corner) {
      const int node = node_of(corners[corner]);
      if (!is_handle(node)) pull.segment<2>(2 * node) += change.segment<2>(2 * corner);
    }
  }
  return pull;
}

void Objective::add_positions(const Points& u, const Positions& positions,
                              EnergyGradient& sum) const {
  sum.energy.penalty = settings_.alpha * penalty(positions, u);
  for (int i = 0; i < positions.count(); ++i) {
    const int v = positions.vertices[static_cast<std::size_t>(i)];
    const int node = node_of(v);
    if (node < 0) continue;
    if (positions.is_eliminated(i))
      sum.gradient.segment<2>(2 * node).setZero();
    else
      sum.gradient.segment<2>(2 * node) +=
          2 * settings_.alpha * positions.weights[i] * (u.col(v) - positions.targets.col(i));
  }
}

void Objective::add_positions(const Positions& positions, SparseSymmetric& hessian) const {
  for (int i = 0; i < positions.count(); ++i) {
    const int node = node_of(positions.vertices[static_cast<std::size_t>(i)]);
    if (node < 0) continue;
    const BlockPlace place = find_block(hessian, node, node);
    const double diagonal =
        positions.is_eliminated(i) ? 1 : 2 * settings_.alpha * positions.weights[i];
    hessian.value[static_cast<std::size_t>(place.first_column)] += diagonal;
    hessian.value[static_cast<std::size_t>(place.second_column)] += diagonal;
  }
}

SparseSymmetric Objective::hessian_pattern() const {
  std::vector<std::pair<int, int>> edges;
  edges.reserve(3 * rest_.size());
  for (const auto& t : triangles_.colwise())
    for (int corner = 0; corner < 3; ++corner)
      edges.emplace_back(node_of(t[corner]), node_of(t[(corner + 1) % 3]));
  return sparse_symmetric(unknowns_.count(), edges);
}

double Objective::largest_step(const Points& u, const Points& step) const {
  double largest = kInfinity;
  for (Eigen::Index t = 0; t < triangles_.cols(); ++t) {
    const Corners x = corners_of(u, triangles_.col(t));
    const Corners s = corners_of(step, triangles_.col(t));
    const Vec2 x1 = x.col(1) - x.col(0), x2 = x.col(2) - x.col(0);
    const Vec2 s1 = s.col(1) - s.col(0), s2 = s.col(2) - s.col(0);
    // 2(A′ − δA) along the line is a quadratic in t.
    const double floor = 2 * settings_.delta * rest_[static_cast<std::size_t>(t)].area;
    largest = std::min(largest, smallest_positive_root(cross(s1, s2), cross(x1, s2) + cross(s1, x2),
                                                       cross(x1, x2) - floor));
  }
  return largest;
}

Points Objective::spread(const Eigen::VectorXd& direction) const {
  Points step = Points::Zero(2, static_cast<Eigen::Index>(unknowns_.node_of_vertex.size()));
  for (int node = 0; node < unknowns_.count(); ++node)
    step.col(unknowns_.vertex_of_node[static_cast<std::size_t>(node)]) =
        direction.segment<2>(2 * node);
  return step;
}

}  // namespace foldless
