// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/linear/buffer.h"
#include "core/linear/half_factor.h"
#include "core/linear/sparse_symmetric.h"
#include "core/linear/symbolic_factor.h"

namespace foldless {

/// How exact a factor is. In full precision it is made and kept in doubles. The others
/// precondition: one that is *rounded* is made in doubles and kept in single precision, one in
/// *single* precision is made in that, half the work, and kept in half, a quarter of the memory.
/// Where this processor does not solve with those, full precision takes their place.
enum class Precision { full, rounded, single };

/// Sparse Cholesky factorization LLᵀ of a symmetric matrix. The symbolic part is kept while the
/// pattern stands. A copy has the factor too; both share it until one factorizes anew.
class Cholesky {
 public:
  /// Symbolic factorization of the pattern. The fill-reducing ordering of the nodes is that of the
  /// pattern before, repaired, where it had as many nodes and that is about as good as a new one.
  void analyze(const SparseSymmetric& matrix);
  /// The same where the nodes are in an order with little fill already.
  void analyze_in_order(const SparseSymmetric& matrix);
  /// Sorts nodes of the pattern by their elimination. Of some of them alone that is an order with
  /// less fill than the factor has. Precondition: is_analyzed().
  void sort_by_elimination(std::vector<int>& nodes) const;
  /// What may stop a factorization from now on.
  void obey(std::stop_token token) { token_ = std::move(token); }
  const std::stop_token& token() const { return token_; }
  bool is_stopped() const { return token_.stop_requested(); }
  /// Factorizes matrix + shift·I; false when that is not positive definite, as far as the precision
  /// tells, or it was stopped. Precondition: analyze() was called with the same pattern.
  bool factorize(const SparseSymmetric& matrix, double shift = 0,
                 Precision precision = Precision::full);
  /// True when analyze() was called.
  bool is_analyzed() const { return symbolic_ != nullptr; }
  /// How many values a factor of the pattern has, with stored zeros. Precondition: is_analyzed().
  std::size_t values() const { return symbolic_->values; }
  /// True when the last factorization succeeded and nothing was analysed since.
  bool has_factor() const { return has_factor_; }
  /// That of the last factorization.
  Precision precision() const { return precision_; }
  /// Solves with the factor. Precondition: has_factor(), in full precision.
  Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side);
  /// The same to about five digits where the factor is well conditioned, in single precision, or to
  /// three from one that is kept in half: so little has the memory to bring. Precondition:
  /// has_factor().
  Eigen::VectorXd precondition(const Eigen::VectorXd& right_hand_side);

 private:
  /// Room that is used again, and that a copy makes for itself.
  struct Work {
    Work() = default;
    Work(const Work&) {}
    Work& operator=(const Work&) { return *this; }

    Buffer<std::byte> fronts;
    Eigen::VectorXd in_order, scratch;
    Buffer<float> single_in_order, single_scratch;
  };

  /// Calls visit(k, node) with the first of every two unknowns, in the order of elimination and in
  /// that of the matrix.
  template <class Visit>
  void for_pairs(const Visit& visit) const;
  /// What factorize() of multifrontal.h returns, in precision_.
  int factorized_columns(const SparseSymmetric& matrix, double shift);
  /// Room for a factor in single precision.
  float* new_single();
  /// Makes the copy of a factor in doubles that preconditions, where it is not made yet.
  void copy_factor();

  double ordered_work_ = 0;  ///< by the last ordering that was made anew
  std::shared_ptr<const SymbolicFactor> symbolic_;
  std::shared_ptr<Buffer<double>> values_;  ///< the factor in full precision
  std::shared_ptr<Buffer<float>> single_;   ///< its copy that preconditions, or a rounded one
  bool has_copy_ = false;                   ///< of the factor there is
  std::shared_ptr<HalfFactor> half_;        ///< the factor that was made in single precision
  Precision precision_ = Precision::full;
  Work work_;
  std::stop_token token_;
  bool has_factor_ = false;
};

}  // namespace foldless
