// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/cholesky.h"

#include "core/linear/ordering.h"
#include "core/linear/triangular_solve.h"

namespace foldless {

void Cholesky::analyze(const SparseSymmetric& matrix, bool keep_ordering) {
  has_factor_ = false;
  if (!keep_ordering || ordering_.size() != static_cast<std::size_t>(matrix.nodes))
    ordering_ = fill_reducing_ordering(matrix);
  symbolic_ = std::make_shared<const SymbolicFactor>(symbolic_factor(matrix, ordering_));
}

bool Cholesky::factorize(const SparseSymmetric& matrix, double shift) {
  has_factor_ = false;
  if (!values_ || values_.use_count() > 1) values_ = std::make_shared<Buffer>();
  values_->reserve(symbolic_->values);
  has_factor_ = foldless::factorize(*symbolic_, matrix, shift, values_->data(), work_.stacks) ==
                matrix.size();
  return has_factor_;
}

Eigen::VectorXd Cholesky::solve(const Eigen::VectorXd& right_hand_side) {
  Eigen::VectorXd& x = work_.in_order;
  x.resize(right_hand_side.size());
  const auto nodes = static_cast<Eigen::Index>(symbolic_->order.size());
  for (Eigen::Index k = 0; k < nodes; ++k)
    x.segment<2>(2 * k) =
        right_hand_side.segment<2>(2 * symbolic_->order[static_cast<std::size_t>(k)]);
  triangular_solve(*symbolic_, values_->data(), x, work_.scratch);
  Eigen::VectorXd solution(x.size());
  for (Eigen::Index k = 0; k < nodes; ++k)
    solution.segment<2>(2 * symbolic_->order[static_cast<std::size_t>(k)]) = x.segment<2>(2 * k);
  return solution;
}

}  // namespace foldless
