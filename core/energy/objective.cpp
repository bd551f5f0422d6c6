// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/objective.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/energy/node_blocks.h"
#include "core/energy/quadratic.h"
#include "core/large_pages.h"
#include "core/threads/zeros.h"

namespace foldless {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Fewer triangles are not worth sharing.
constexpr Eigen::Index kSharedFrom = 2048;
constexpr int kFewestRanges = 8, kRangesOfAThread = 4;

/// Whether c + b t + a t² is positive for all 0 ≤ t ≤ bound, told without a root; where that is
/// close, or the bound infinite, it may be so all the same.
bool is_clearly_positive(double a, double b, double c, double bound) {
  constexpr double kClear = 1e-9;
  return c * (1 - kClear) + bound * (std::min(b, 0.0) + bound * std::min(a, 0.0)) > 0;
}

/// Smallest positive root of c + b t + a t², or infinity; 0 where c is not positive. One beyond
/// `bound` may be missed.
double smallest_positive_root(double a, double b, double c, double bound) {
  if (!(c > 0)) return 0;
  if (is_clearly_positive(a, b, c, bound)) return kInfinity;
  double root = kInfinity;
  for (const double t : roots(a, b, c))
    if (t > 0) root = std::min(root, t);  // NaN falls through
  return root;
}

void add_penalty(const Energy& energy, const Points& u, EnergyGradient& sum) {
  const auto& [settings, constraints] = energy;
  sum.energy.penalty = settings.alpha * penalty(constraints, u);
  for (int i = 0; i < constraints.count(); ++i) {
    const int v = constraints.vertices[static_cast<std::size_t>(i)];
    if (constraints.is_eliminated(i))
      sum.gradient.segment<2>(2 * v).setZero();
    else
      sum.gradient.segment<2>(2 * v) +=
          2 * settings.alpha * constraints.weights[i] * (u.col(v) - constraints.targets.col(i));
  }
}

void add_penalty(const Energy& energy, SparseSymmetric& hessian) {
  const auto& [settings, constraints] = energy;
  for (int i = 0; i < constraints.count(); ++i) {
    const int v = constraints.vertices[static_cast<std::size_t>(i)];
    const BlockPlace place = find_block(hessian, v, v);
    const double diagonal =
        constraints.is_eliminated(i) ? 1 : 2 * settings.alpha * constraints.weights[i];
    hessian.value[static_cast<std::size_t>(place.first_column)] += diagonal;
    hessian.value[static_cast<std::size_t>(place.second_column)] += diagonal;
  }
}

/// The part of a side of a gap in ∇²E; its third corner is none.
Eigen::Matrix<double, 6, 6> block_of(const Mat2& curvature) {
  Eigen::Matrix<double, 6, 6> block = Eigen::Matrix<double, 6, 6>::Zero();
  block.block<2, 2>(0, 0) = block.block<2, 2>(2, 2) = curvature;
  block.block<2, 2>(0, 2) = block.block<2, 2>(2, 0) = -curvature;
  return block;
}

}  // namespace

Objective::Objective(const MeshPair& mesh, const Constraints& constraints)
    : has_hard_handle_(have_hard_handles(constraints, mesh.vertex_count())),
      triangles_(Triangles::Constant(3, mesh.face_count(), -1)),
      guard_(mesh) {
  const auto faces = static_cast<std::size_t>(mesh.face_count());
  reserve_large_pages(rest_, faces);
  rest_.resize(faces);
  follow_flips(mesh);
}

void Objective::follow_flips(const MeshPair& mesh) {
  for_triangles(triangles_.cols(), [&](std::ptrdiff_t i) {
    const Eigen::Vector3i t = mesh.triangles().col(i);
    if (triangles_.col(i) == t) return;
    triangles_.col(i) = t;
    rest_[static_cast<std::size_t>(i)] = rest_element(mesh, t);
  });
  triangles_of_handles_ = triangles_where(triangles_.cols(), [&](int i) {
    return std::ranges::any_of(triangles_.col(i), [&](int v) { return has_hard_handle(v); });
  });
  corners_.clear();
  vertex_ranges_.clear();
  if (const Team* team = present_team(); team && triangles_.cols() >= kSharedFrom) {
    vertex_ranges_ = compact_ranges(triangles_, has_hard_handle_.size(),
                                    std::max(kFewestRanges, kRangesOfAThread * team->size()));
    if (vertex_ranges_.empty()) corners_.assign(triangles_, has_hard_handle_.size());
  }
  guard_.follow_flips(triangles_, rest_);
}

EnergyTerms Objective::value(const Energy& energy, const Points& u) const {
  EnergyTerms terms;
  if (is_shared())
    sum_shared(batch_of(energy, u), terms);
  else
    sum_elements(batch_of(energy, u), terms);
  if (energy.settings.guards_boundary() && terms.barrier < kInfinity)
    terms.barrier += energy.settings.gap_weight * guard_.value(u);
  if (terms.barrier == kInfinity) return {0, 0, kInfinity};
  terms.penalty = energy.settings.alpha * penalty(energy.constraints, u);
  return terms;
}

EnergyGradient Objective::gradient(const Energy& energy, const Points& u) const {
  EnergyGradient sum{{}, zeros<Eigen::VectorXd>(u.size())};
  if (is_in_ranges())
    sum_ranges(batch_of(energy, u), sum);
  else if (is_shared())
    sum_shared(batch_of(energy, u), sum);
  else
    sum_elements(batch_of(energy, u), sum);
  add_gaps(energy.settings, u, sum);
  add_penalty(energy, u, sum);
  return sum;
}

EnergyGradient Objective::assemble(const Energy& energy, const Points& u, SparseSymmetric& hessian,
                                   double clamping) const {
  EnergyGradient sum{{}, zeros<Eigen::VectorXd>(u.size())};
  const ElementBatch batch = batch_of(energy, u, clamping);
  if (is_in_ranges())
    sum_ranges(batch, energy.constraints, sum, hessian);
  else if (is_shared())
    sum_shared(batch, energy.constraints, sum, hessian);
  else
    sum_elements(batch, energy.constraints, sum, hessian);
  add_gaps(energy.settings, u, sum);
  add_gaps(energy, u, hessian);
  add_penalty(energy, u, sum);
  add_penalty(energy, hessian);
  return sum;
}

void Objective::add_columns(const BlocksOf<double>& blocks, const Corner& of,
                            const Constraints& constraints, SparseSymmetric& hessian) const {
  const int j = node_of(triangles_(of.corner, of.triangle), constraints);
  if (j < 0) return;
  add_diagonal_block(block_of_corners(blocks, of.corner, of.corner), j, hessian);
  for (int other = 0; other < 3; ++other) {
    const int i = node_of(triangles_(other, of.triangle), constraints);
    if (i > j) add_later_block(block_of_corners(blocks, other, of.corner), i, j, hessian);
  }
}

Eigen::VectorXd Objective::pull_of_handles(const EnergySettings& settings, const Points& u,
                                           const Points& way) const {
  Eigen::VectorXd pull = zeros<Eigen::VectorXd>(u.size());
  for (const int t : triangles_of_handles_) {
    const auto& corners = triangles_.col(t);
    const Corners moves = corners_of(way, corners);
    if (moves.isZero(0)) continue;
    const ElementHessian e =
        element_hessian(settings, reference(settings, t), corners_of(u, corners), 1);
    const Eigen::Matrix<double, 6, 1> change = e.hessian * moves.reshaped();
    for (int corner = 0; corner < 3; ++corner)
      if (!has_hard_handle(corners[corner]))
        pull.segment<2>(2 * corners[corner]) += change.segment<2>(2 * corner);
  }
  if (settings.guards_boundary()) add_pull_of_gaps(settings, u, way, pull);
  return pull;
}

void Objective::add_gaps(const EnergySettings& settings, const Points& u,
                         EnergyGradient& sum) const {
  if (settings.guards_boundary())
    sum.energy.barrier +=
        settings.gap_weight * guard_.add_gradient(settings.gap_weight, u, sum.gradient);
}

void Objective::add_gaps(const Energy& energy, const Points& u, SparseSymmetric& hessian) const {
  const auto& [settings, constraints] = energy;
  if (!settings.guards_boundary()) return;
  for (const GapSide& side : guard_.curved_sides(u))
    add_block(hessian,
              {node_of(side.vertex, constraints), node_of(side.neighbour, constraints), -1},
              block_of(settings.gap_weight * side.curvature));
}

void Objective::add_pull_of_gaps(const EnergySettings& settings, const Points& u, const Points& way,
                                 Eigen::VectorXd& pull) const {
  for (const GapSide& side : guard_.curved_sides(u)) {
    const Vec2 change =
        settings.gap_weight * side.curvature * (way.col(side.neighbour) - way.col(side.vertex));
    if (!has_hard_handle(side.neighbour)) pull.segment<2>(2 * side.neighbour) += change;
    if (!has_hard_handle(side.vertex)) pull.segment<2>(2 * side.vertex) -= change;
  }
}

SparseSymmetric Objective::hessian_pattern() const {
  if (is_in_ranges()) return ranged_pattern();
  if (is_shared()) return shared_pattern();
  std::vector<std::pair<int, int>> edges;
  edges.reserve(3 * rest_.size());
  for (const auto& t : triangles_.colwise())
    for (int corner = 0; corner < 3; ++corner) edges.emplace_back(t[corner], t[(corner + 1) % 3]);
  return sparse_symmetric(static_cast<int>(has_hard_handle_.size()), edges);
}

double Objective::largest_step_of(Eigen::Index t, const EnergySettings& settings,
                                  const Segment& segment) const {
  const Corners x = corners_of(segment.u, triangles_.col(t));
  const Corners s = corners_of(segment.step, triangles_.col(t));
  const Vec2 x1 = x.col(1) - x.col(0), x2 = x.col(2) - x.col(0);
  const Vec2 s1 = s.col(1) - s.col(0), s2 = s.col(2) - s.col(0);
  // 2(A′ − δA) along the line is a quadratic in t.
  const double floor = 2 * settings.delta * rest_[static_cast<std::size_t>(t)].area;
  return smallest_positive_root(cross(s1, s2), cross(x1, s2) + cross(s1, x2), cross(x1, x2) - floor,
                                segment.bound);
}

double Objective::largest_step(const EnergySettings& settings, const Points& u,
                               const Points& step) const {
  const auto bound_of = [&](Eigen::Index t, double least) {
    return largest_step_of(t, settings, {u, step, least});
  };
  return std::min(largest_step_of_gaps(settings, u, step),
                  least_of_triangles(triangles_.cols(), bound_of));
}

double Objective::largest_step_of_gaps(const EnergySettings& settings, const Points& u,
                                       const Points& step) const {
  return settings.guards_boundary() ? guard_.largest_step(u, step) : kInfinity;
}

std::vector<int> Objective::triangles_in_way(const EnergySettings& settings, const Points& u,
                                             const Points& step, double bound) const {
  return triangles_where(triangles_.cols(), [&](int t) {
    return largest_step_of(t, settings, {u, step, bound}) < bound;
  });
}

bool Objective::is_feasible(const EnergySettings& settings, const Points& u,
                            const Points& end) const {
  const auto is_open = [&](Eigen::Index t) {
    const Corners x = corners_of(end, triangles_.col(t));
    const double floor = 2 * settings.delta * rest_[static_cast<std::size_t>(t)].area;
    return cross(x.col(1) - x.col(0), x.col(2) - x.col(0)) > floor;
  };
  return all_triangles(triangles_.cols(), is_open) && are_gaps_open(settings, u, end);
}

bool Objective::are_gaps_open(const EnergySettings& settings, const Points& u,
                              const Points& end) const {
  return !settings.guards_boundary() || guard_.stays_open(u, end);
}

}  // namespace foldless
