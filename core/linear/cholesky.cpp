// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/cholesky.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "core/linear/elimination_tree.h"
#include "core/linear/half_precision_solve.h"
#include "core/linear/multifrontal.h"
#include "core/linear/ordering.h"
#include "core/linear/repaired_ordering.h"
#include "core/linear/shared_vectors.h"
#include "core/linear/single_precision_solve.h"
#include "core/linear/sweep.h"
#include "core/linear/symbolic_analysis.h"
#include "core/linear/triangular_solve.h"
#include "core/threads/team.h"

namespace foldless {
namespace {

/// From so many values on, 160 MB in doubles, the factor, its copy in single precision and the
/// update matrices are not held all at once: to be given memory anew costs little beside a
/// factorization.
constexpr std::size_t kManyValues = 20'000'000;

/// Times the work of the last ordering that was made anew. With 1.25 random scenes took a fiftieth
/// longer, with 2 as long as with this.
constexpr double kMostWorkOfRepaired = 1.5;

/// One that no copy looks at.
template <class Values>
Values& own(std::shared_ptr<Values>& values) {
  if (!values || values.use_count() > 1) values = std::make_shared<Values>();
  return *values;
}

}  // namespace

void Cholesky::analyze(const SparseSymmetric& matrix) {
  has_factor_ = false;
  std::optional<EliminationTree> tree;
  if (symbolic_ && symbolic_->order.size() == static_cast<std::size_t>(matrix.nodes))
    tree = elimination_tree(matrix, repaired_ordering(matrix, symbolic_->order, symbolic_->parent));
  if (!tree || tree->work() > kMostWorkOfRepaired * ordered_work_) {
    tree = elimination_tree(matrix, fill_reducing_ordering(matrix));
    ordered_work_ = tree->work();
  }
  symbolic_ = std::make_shared<const SymbolicFactor>(symbolic_factor(std::move(*tree)));
}

void Cholesky::analyze_in_order(const SparseSymmetric& matrix) {
  has_factor_ = false;
  std::vector<int> order(static_cast<std::size_t>(matrix.nodes));
  std::iota(order.begin(), order.end(), 0);
  EliminationTree tree = elimination_tree(matrix, order);
  ordered_work_ = tree.work();
  symbolic_ = std::make_shared<const SymbolicFactor>(symbolic_factor(std::move(tree)));
}

void Cholesky::sort_by_elimination(std::vector<int>& nodes) const {
  const auto place = [&](int node) { return symbolic_->place[static_cast<std::size_t>(node)]; };
  std::ranges::sort(nodes, {}, place);
}

bool Cholesky::factorize(const SparseSymmetric& matrix, double shift, Precision precision) {
  has_factor_ = has_copy_ = false;
  precision_ = solves_in_single_precision() ? precision : Precision::full;
  has_factor_ = factorized_columns(matrix, shift) == matrix.size();
  return has_factor_;
}

int Cholesky::factorized_columns(const SparseSymmetric& matrix, double shift) {
  Buffer<std::byte>& fronts = work_.fronts;
  switch (precision_) {
    case Precision::single:
      return foldless::factorize(*symbolic_, matrix, shift, own(half_), fronts, token_);
    case Precision::rounded:
      return foldless::factorize(*symbolic_, matrix, shift, new_single(), fronts, token_);
    case Precision::full: break;
  }
  const bool is_many = symbolic_->values >= kManyValues;
  if (is_many) {
    single_.reset();
    half_.reset();
  }
  Buffer<double>& values = own(values_);
  values.reserve(symbolic_->values);
  const int found = foldless::factorize(*symbolic_, matrix, shift, values.data(), fronts, token_);
  if (is_many) fronts = {};
  return found;
}

void Cholesky::copy_factor() {
  if (has_copy_) return;
  to_single_precision(*symbolic_, values_->data(), new_single());
  has_copy_ = true;
}

float* Cholesky::new_single() {
  Buffer<float>& single = own(single_);
  single.reserve(symbolic_->values + kSingleOverrun);
  std::fill_n(single.data() + symbolic_->values, kSingleOverrun, 0.0F);
  return single.data();
}

template <class Visit>
void Cholesky::for_pairs(const Visit& visit) const {
  const std::vector<int>& order = symbolic_->order;
  each_in_ranges(static_cast<std::ptrdiff_t>(order.size()), kEntriesTogether,
                 [&](std::ptrdiff_t k) {
                   visit(2 * k, 2 * Eigen::Index{order[static_cast<std::size_t>(k)]});
                 });
}

Eigen::VectorXd Cholesky::solve(const Eigen::VectorXd& right_hand_side) {
  Eigen::VectorXd& x = work_.in_order;
  x.resize(symbolic_->solve_size());
  for_pairs([&](Eigen::Index k, Eigen::Index node) {
    x.segment<2>(k) = right_hand_side.segment<2>(node);
  });
  triangular_solve(*symbolic_, values_->data(), x, work_.scratch);
  Eigen::VectorXd solution(right_hand_side.size());
  for_pairs(
      [&](Eigen::Index k, Eigen::Index node) { solution.segment<2>(node) = x.segment<2>(k); });
  return solution;
}

Eigen::VectorXd Cholesky::precondition(const Eigen::VectorXd& right_hand_side) {
  const double scale = largest_magnitude(right_hand_side);
  if (scale == 0) return Eigen::VectorXd::Zero(right_hand_side.size());
  if (!solves_in_single_precision()) return solve(right_hand_side);
  if (precision_ == Precision::full) copy_factor();
  work_.single_in_order.reserve(static_cast<std::size_t>(symbolic_->solve_size()));
  work_.single_scratch.reserve(sweep_work_size(*symbolic_, kSingleOverrun));
  float* x = work_.single_in_order.data();
  for_pairs([&](Eigen::Index k, Eigen::Index node) {
    for (Eigen::Index i = 0; i < 2; ++i)
      x[k + i] = static_cast<float>(right_hand_side[node + i] / scale);
  });
  if (precision_ == Precision::single)
    triangular_solve_half(*symbolic_, *half_, x, work_.single_scratch.data());
  else
    triangular_solve_single(*symbolic_, single_->data(), x, work_.single_scratch.data());
  Eigen::VectorXd solution(right_hand_side.size());
  for_pairs([&](Eigen::Index k, Eigen::Index node) {
    for (Eigen::Index i = 0; i < 2; ++i) solution[node + i] = scale * x[k + i];
  });
  return solution;
}

}  // namespace foldless
