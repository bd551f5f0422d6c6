// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/hessian_factor.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include "core/linear/single_precision_solve.h"
#include "core/threads/values_of_ranges.h"

namespace foldless {
namespace {

/// Unknowns from which on less memory is worth more iterations, and to solve for nodes that changed
/// by themselves saves more than it costs.
constexpr int kLargeFrom = 4000;

/// How long an earlier factor serves.
struct Lag {
  int most_iterations;  ///< of a solve; an iteration costs a quarter of a factorization or less
  int iterations_of_a_far_factor;  ///< which is too far from ∇²E to serve once more
};
constexpr Lag kLagOfLarge{8, 5};
/// Of few unknowns the analysis, after flips, costs as much as the factorization.
constexpr Lag kLagOfSmall{12, 8};

/// Of iterations from a coarse mesh, where the second lowers the model by a tenth of what the first
/// does when they go well. They cost less than those from a factor, which costs far more.
constexpr int kMostCoarseIterations = 8;
constexpr double kLargestGainOfCoarse = 0.5;

/// Nodes whose stiffness changed by more than a factor are solved for by themselves, with so many
/// rings of neighbours: by the first factor for which these are no more than this part of all
/// nodes, or than a hundred, whose factor is always small beside that of all.
constexpr double kChangedStiffness[] = {1.05, 1.1, 1.2, 1.5, 2, 4};
constexpr int kRingsOfChangedNodes = 2;
constexpr double kMostSolvedLocally = 0.02;
constexpr double kFewNodes = 100;

bool is_large(const SparseSymmetric& matrix) { return matrix.size() >= kLargeFrom; }

/// The trace of the node's block.
double stiffness_of(const SparseSymmetric& A, std::size_t node) {
  return A.value[static_cast<std::size_t>(A.first_column(node))] +
         A.value[static_cast<std::size_t>(A.second_column(node))];
}

/// A node whose stiffness is no more what it was in the matrix of the factor.
struct ChangedNode {
  int node;
  double by;  ///< a factor, > 1
};

/// By more than the least factor that counts, in ranges that threads share.
std::vector<ChangedNode> changed_nodes(const SparseSymmetric& matrix,
                                       const std::vector<double>& stiffness) {
  constexpr std::ptrdiff_t kNodesTogether = 4096;
  return joined_ranges(matrix.nodes, kNodesTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    std::vector<ChangedNode> changed;
    for (std::ptrdiff_t i = begin; i < end; ++i) {
      const auto node = static_cast<std::size_t>(i);
      const double before = stiffness[node], now = stiffness_of(matrix, node);
      const double by =
          now > 0 ? std::max(now / before, before / now) : std::numeric_limits<double>::infinity();
      if (by > kChangedStiffness[0]) changed.push_back({static_cast<int>(i), by});
    }
    return changed;
  });
}

}  // namespace

void HessianFactor::outdate_pattern() {
  is_analyzed_ = false;
  outdate();
}

void HessianFactor::forget_mesh() {
  is_near_ = is_of_mesh_ = false;
  coarse_.reset();
}

void HessianFactor::analyze(const SparseSymmetric& matrix) {
  if (is_analyzed_) return;
  cholesky_.analyze(matrix);
  is_analyzed_ = true;
}

Precision HessianFactor::for_iterations(const Hessian& hessian) const {
  return solves_in_single_precision() && is_large(hessian.matrix) ? roughest_ : Precision::full;
}

void HessianFactor::set_too_rough() {
  roughest_ = roughest_ == Precision::single ? Precision::rounded : Precision::full;
}

bool HessianFactor::factorize(const Hessian& hessian, double mu, Precision precision) {
  coarse_.reset();
  kind_ = hessian.kind;
  is_near_ = cholesky_.factorize(hessian.matrix, mu, precision);
  is_of_mesh_ = is_near_;
  stiffness_.clear();
  if (is_large(hessian.matrix))
    for (std::size_t node = 0; node < static_cast<std::size_t>(hessian.matrix.nodes); ++node)
      stiffness_.push_back(stiffness_of(hessian.matrix, node));
  is_own_ = is_near_ && mu == 0;
  return is_near_;
}

std::optional<ConjugateGradientSolution> HessianFactor::solve_later(
    const Hessian& hessian, const Eigen::VectorXd& b, double least_gain,
    std::span<const Eigen::VectorXd> guesses) {
  if (!is_near(hessian.kind)) return solve_from_coarse(hessian, b, least_gain);
  const Lag lag = is_large(hessian.matrix) ? kLagOfLarge : kLagOfSmall;
  ConjugateGradientSettings settings{least_gain, lag.most_iterations};
  settings.room = &room_;
  std::optional<LocalSolve> local;
  if (!is_own_) {
    settings.guesses = guesses;  // they cost more than they bring where the factor is its own
    local = solve_of_changed_nodes(hessian.matrix);
  }
  if (local) {
    if (!local->is_definite())
      return ConjugateGradientSolution{{}, 0, ConjugateGradientEnd::indefinite};
    settings.local = &*local;
  }
  ConjugateGradientSolution solution = conjugate_gradients(hessian.matrix, b, cholesky_, settings);
  if (solution.end == ConjugateGradientEnd::stopped) return std::nullopt;
  const bool is_slow = solution.end == ConjugateGradientEnd::slow;
  is_near_ = !is_slow && (local || solution.iterations < lag.iterations_of_a_far_factor);
  if (is_slow) return std::nullopt;
  return solution;
}

/// Of the nodes that became stiffer or softer, and their neighbours: a few of them would cost most
/// of the iterations.
std::optional<LocalSolve> HessianFactor::solve_of_changed_nodes(
    const SparseSymmetric& matrix) const {
  if (stiffness_.empty()) return std::nullopt;
  std::vector<ChangedNode> changed = changed_nodes(matrix, stiffness_);
  const auto most =
      static_cast<std::size_t>(std::max(kFewNodes, kMostSolvedLocally * matrix.nodes));
  for (const double least : kChangedStiffness) {
    std::erase_if(changed, [&](const ChangedNode& node) { return node.by <= least; });
    if (changed.empty()) return std::nullopt;
    if (changed.size() > most) continue;
    std::vector<int> nodes;
    nodes.reserve(changed.size());
    for (const ChangedNode& node : changed) nodes.push_back(node.node);
    for (int ring = 0; ring < kRingsOfChangedNodes; ++ring) nodes = with_neighbours(matrix, nodes);
    if (nodes.size() > most) continue;
    cholesky_.sort_by_elimination(nodes);
    return LocalSolve(matrix, nodes);
  }
  return std::nullopt;
}

std::optional<ConjugateGradientSolution> HessianFactor::solve_from_coarse(const Hessian& hessian,
                                                                          const Eigen::VectorXd& b,
                                                                          double least_gain) {
  if (!coarse_ || coarse_->kind != hessian.kind) return std::nullopt;
  VCycle cycle(hessian.matrix, *coarse_->grid);
  if (!cycle.is_definite())
    return ConjugateGradientSolution{{}, 0, ConjugateGradientEnd::indefinite};
  ConjugateGradientSolution solution =
      conjugate_gradients(hessian.matrix, b, std::ref(cycle),
                          {.least_gain = least_gain,
                           .most_iterations = kMostCoarseIterations,
                           .largest_gain = kLargestGainOfCoarse,
                           .token = cholesky_.token(),
                           .room = &room_});
  if (solution.end == ConjugateGradientEnd::stopped) return std::nullopt;
  if (solution.end != ConjugateGradientEnd::slow) return solution;
  coarse_.reset();
  return std::nullopt;
}

std::optional<CoarseHessian> HessianFactor::as_coarse(Interpolation to_finer,
                                                      Hessian hessian) const {
  if (coarse_) {
    auto grid =
        std::make_shared<CoarseGrid>(std::move(to_finer), std::move(hessian.matrix), coarse_->grid);
    if (!grid->is_definite()) return std::nullopt;
    return CoarseHessian{hessian.kind, std::move(grid)};
  }
  if (!is_of_mesh_ || !cholesky_.has_factor()) return std::nullopt;
  return CoarseHessian{kind_, std::make_shared<CoarseGrid>(std::move(to_finer), cholesky_)};
}

}  // namespace foldless
