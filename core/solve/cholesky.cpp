// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/cholesky.h"

#include <cholmod.h>

#include <algorithm>
#include <new>
#include <utility>
#include <vector>

namespace foldless {
namespace {

/// A view of our arrays as a CHOLMOD matrix, lower triangle, nothing copied.
cholmod_sparse view(int size, const std::vector<int>& start, const std::vector<int>& row,
                    const double* value) {
  cholmod_sparse m{};
  m.nrow = m.ncol = static_cast<std::size_t>(size);
  m.nzmax = row.size();
  // CHOLMOD takes pointers to non-const and does not write through them.
  m.p = const_cast<int*>(start.data());
  m.i = const_cast<int*>(row.data());
  m.x = const_cast<double*>(value);
  m.stype = -1;
  m.itype = CHOLMOD_INT;
  m.xtype = value ? CHOLMOD_REAL : CHOLMOD_PATTERN;
  m.dtype = CHOLMOD_DOUBLE;
  m.sorted = 1;
  m.packed = 1;
  return m;
}

}  // namespace

struct Cholesky::State {
  State() {
    cholmod_start(&common);
    common.print = 0;
    common.try_catch = 1;  // not positive definite is control flow, not news
    common.quick_return_if_not_posdef = 1;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_GIVEN;
    common.postorder = 1;
    common.final_asis = 1;
    common.final_ll = 1;
  }
  ~State() {
    cholmod_free_dense(&solution, &common);
    cholmod_free_dense(&work_y, &common);
    cholmod_free_dense(&work_e, &common);
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  void order(const SparseSymmetric& matrix);

  cholmod_common common;
  cholmod_factor* factor = nullptr;
  cholmod_dense* solution = nullptr;
  cholmod_dense* work_y = nullptr;
  cholmod_dense* work_e = nullptr;
  std::vector<int> ordering;  ///< of the unknowns
  bool factorized = false;
};

/// AMD on the vertex graph, a quarter of the work of AMD on the unknowns and as good.
void Cholesky::State::order(const SparseSymmetric& matrix) {
  std::vector<int> vertices(static_cast<std::size_t>(matrix.nodes));
  cholmod_sparse graph = view(matrix.nodes, matrix.graph_start, matrix.graph, nullptr);
  if (!cholmod_amd(&graph, nullptr, 0, vertices.data(), &common)) throw std::bad_alloc();
  ordering.resize(static_cast<std::size_t>(matrix.size()));
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    ordering[2 * k] = 2 * vertices[k];
    ordering[2 * k + 1] = 2 * vertices[k] + 1;
  }
}

Cholesky::Cholesky() : state_(std::make_unique<State>()) {}
Cholesky::~Cholesky() = default;
Cholesky::Cholesky(const Cholesky&) : Cholesky() {}
Cholesky& Cholesky::operator=(const Cholesky& other) {
  if (this != &other) state_ = std::make_unique<State>();
  return *this;
}
Cholesky::Cholesky(Cholesky&&) noexcept = default;
Cholesky& Cholesky::operator=(Cholesky&&) noexcept = default;

void Cholesky::analyze(const SparseSymmetric& matrix, bool keep_ordering) {
  State& s = *state_;
  s.factorized = false;
  const auto size = static_cast<std::size_t>(matrix.size());
  if (!keep_ordering || s.ordering.size() != size) s.order(matrix);
  s.common.supernodal =
      matrix.size() >= Cholesky::kSupernodalFrom ? CHOLMOD_SUPERNODAL : CHOLMOD_SIMPLICIAL;
  cholmod_free_factor(&s.factor, &s.common);
  cholmod_sparse a = view(matrix.size(), matrix.column_start, matrix.row, matrix.value.data());
  s.factor = cholmod_analyze_p(&a, s.ordering.data(), nullptr, 0, &s.common);
  if (!s.factor) throw std::bad_alloc();
}

bool Cholesky::factorize(const SparseSymmetric& matrix, double shift) {
  State& s = *state_;
  cholmod_sparse a = view(matrix.size(), matrix.column_start, matrix.row, matrix.value.data());
  double beta[2] = {shift, 0};
  cholmod_factorize_p(&a, beta, nullptr, 0, s.factor, &s.common);
  if (s.common.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
  s.factorized = s.common.status == CHOLMOD_OK && s.factor->minor == s.factor->n;
  return s.factorized;
}

bool Cholesky::is_analyzed() const { return state_->factor != nullptr; }
bool Cholesky::has_factor() const { return state_->factorized; }

Eigen::VectorXd Cholesky::solve(const Eigen::VectorXd& right_hand_side) {
  State& s = *state_;
  cholmod_dense b{};
  b.nrow = b.nzmax = b.d = static_cast<std::size_t>(right_hand_side.size());
  b.ncol = 1;
  b.x = const_cast<double*>(right_hand_side.data());
  b.xtype = CHOLMOD_REAL;
  b.dtype = CHOLMOD_DOUBLE;
  if (!cholmod_solve2(CHOLMOD_A, s.factor, &b, nullptr, &s.solution, nullptr, &s.work_y, &s.work_e,
                      &s.common))
    throw std::bad_alloc();
  return Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(s.solution->x),
                                           right_hand_side.size());
}

}  // namespace foldless
