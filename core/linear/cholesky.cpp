// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/cholesky.h"

#include <cholmod.h>
#include <dlfcn.h>
#include <link.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <mutex>
#include <new>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "core/linear/symbolic_factor.h"
#include "core/linear/triangular_solve.h"

namespace {

/// Where a library lies in memory.
struct Library {
  std::uintptr_t begin = 0, end = 0;

  bool holds(std::uintptr_t address) const { return begin <= address && address < end; }
};

template <typename Function>
std::uintptr_t address_of(Function* function) {
  return reinterpret_cast<std::uintptr_t>(function);
}

/// The segments of a library as the loader tells them.
Library library_of(const dl_phdr_info& info) {
  Library library{std::numeric_limits<std::uintptr_t>::max(), 0};
  for (const ElfW(Phdr) & segment : std::span(info.dlpi_phdr, info.dlpi_phnum)) {
    if (segment.p_type != PT_LOAD) continue;
    library.begin = std::min<std::uintptr_t>(library.begin, info.dlpi_addr + segment.p_vaddr);
    library.end =
        std::max<std::uintptr_t>(library.end, info.dlpi_addr + segment.p_vaddr + segment.p_memsz);
  }
  return library;
}

Library find_cholmod() {
  Library cholmod;
  dl_iterate_phdr(
      [](dl_phdr_info* info, std::size_t, void* found) {
        const Library library = library_of(*info);
        if (!library.holds(address_of(&cholmod_start))) return 0;
        *static_cast<Library*>(found) = library;
        return 1;
      },
      &cholmod);
  return cholmod;
}

}  // namespace

/// CHOLMOD opens a parallel region for every few columns, and libgomp makes a team for each, even
/// of one thread: half of the time of a factorization. This definition comes before libgomp's: such
/// a region runs on the calling thread, outside of any team. Regions of others, such as a BLAS with
/// threads, which would wait for theirs for ever, are libgomp's as ever.
// NOLINTBEGIN(readability-identifier-naming, readability-redundant-declaration): names of others
extern "C" __attribute__((visibility("default"))) void GOMP_parallel(void (*region)(void*),
                                                                     void* data, unsigned,
                                                                     unsigned);
void GOMP_parallel(void (*region)(void*), void* data, unsigned threads, unsigned flags) {
  static const Library cholmod = find_cholmod();
  static const auto of_libgomp =
      reinterpret_cast<decltype(&GOMP_parallel)>(dlsym(RTLD_NEXT, "GOMP_parallel"));
  if (cholmod.holds(address_of(region)) || !of_libgomp) return region(data);
  of_libgomp(region, data, threads, flags);
}

/// CHOLMOD asks for the time before and after every call of the BLAS, a tenth of the time of a
/// small factorization, for statistics that nobody reads here.
extern "C" __attribute__((visibility("default"))) double SuiteSparse_time();
double SuiteSparse_time() { return 0; }
// NOLINTEND(readability-identifier-naming, readability-redundant-declaration)

namespace foldless {
namespace {

/// Supernodal factorizations call the BLAS of the system, which may be built for one caller at a
/// time: two solves at once then spoil each other's numbers (measured with the OpenBLAS of Debian).
std::unique_lock<std::mutex> lock_blas(const cholmod_factor& factor) {
  static std::mutex one_caller;
  return factor.is_super ? std::unique_lock(one_caller) : std::unique_lock<std::mutex>();
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
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }
  State(const State& other) : State() {
    ordering = other.ordering;
    start = other.start;
    row = other.row;
    place = other.place;
    factorized = other.factorized;
    if (!other.factor) return;
    factor = cholmod_copy_factor(other.factor, &common);
    if (!factor) throw std::bad_alloc();
  }
  State& operator=(const State&) = delete;

  void order(const SparseSymmetric& matrix);
  void permute_pattern(const SparseSymmetric& matrix);
  cholmod_sparse permuted(const SparseSymmetric& matrix);

  cholmod_common common;
  cholmod_factor* factor = nullptr;
  std::vector<int> ordering;  ///< of the nodes
  // The matrix in the order of the factor, made once a pattern: CHOLMOD by itself would transpose
  // the matrix twice for every factorization.
  std::vector<int> start, row;
  std::vector<double> value;
  std::vector<int> place;  ///< where each value of the matrix goes
  Eigen::VectorXd right_hand_side, work;
  bool factorized = false;
};

/// AMD on the vertex graph, a quarter of the work of AMD on the unknowns and as good.
void Cholesky::State::order(const SparseSymmetric& matrix) {
  ordering.resize(static_cast<std::size_t>(matrix.nodes));
  cholmod_sparse graph = view_of_graph(matrix);
  if (!cholmod_amd(&graph, nullptr, 0, ordering.data(), &common)) throw std::bad_alloc();
}

/// Supernodal factorizations read the lower triangle as it is, simplicial ones the upper.
void Cholesky::State::permute_pattern(const SparseSymmetric& matrix) {
  const auto size = static_cast<std::size_t>(matrix.size());
  const auto* permutation = static_cast<const int*>(factor->Perm);
  std::vector<int> position(size);
  for (std::size_t k = 0; k < size; ++k)
    position[static_cast<std::size_t>(permutation[k])] = static_cast<int>(k);
  const auto visit = [&](const auto& put) {
    for (std::size_t column = 0, k = 0; column < size; ++column)
      for (; k < static_cast<std::size_t>(matrix.column_start[column + 1]); ++k) {
        const int a = position[column], b = position[static_cast<std::size_t>(matrix.row[k])];
        const auto [least, greatest] = std::minmax(a, b);
        if (factor->is_super)
          put(k, greatest, static_cast<std::size_t>(least));
        else
          put(k, least, static_cast<std::size_t>(greatest));
      }
  };
  start.assign(size + 1, 0);
  visit([&](std::size_t, int, std::size_t column) { ++start[column + 1]; });
  std::partial_sum(start.begin(), start.end(), start.begin());
  row.resize(matrix.row.size());
  place.resize(matrix.row.size());
  std::vector<int> next(start.begin(), start.end() - 1);
  visit([&](std::size_t k, int r, std::size_t column) {
    place[k] = next[column]++;
    row[static_cast<std::size_t>(place[k])] = r;
  });
}

cholmod_sparse Cholesky::State::permuted(const SparseSymmetric& matrix) {
  value.resize(matrix.value.size());
  for (std::size_t k = 0; k < place.size(); ++k)
    value[static_cast<std::size_t>(place[k])] = matrix.value[k];
  cholmod_sparse m{};
  m.nrow = m.ncol = static_cast<std::size_t>(matrix.size());
  m.nzmax = row.size();
  m.p = start.data();
  m.i = row.data();
  m.x = value.data();
  m.stype = factor->is_super ? -1 : 1;
  m.itype = CHOLMOD_INT;
  m.xtype = CHOLMOD_REAL;
  m.dtype = CHOLMOD_DOUBLE;
  m.packed = 1;
  return m;
}

Cholesky::Cholesky() : state_(std::make_unique<State>()) {}
Cholesky::~Cholesky() = default;
Cholesky::Cholesky(const Cholesky& other) : state_(std::make_unique<State>(*other.state_)) {}
Cholesky& Cholesky::operator=(const Cholesky& other) {
  if (this != &other) state_ = std::make_unique<State>(*other.state_);
  return *this;
}
Cholesky::Cholesky(Cholesky&&) noexcept = default;
Cholesky& Cholesky::operator=(Cholesky&&) noexcept = default;

void Cholesky::analyze(const SparseSymmetric& matrix, bool keep_ordering) {
  State& s = *state_;
  s.factorized = false;
  if (!keep_ordering || s.ordering.size() != static_cast<std::size_t>(matrix.nodes))
    s.order(matrix);
  s.common.supernodal =
      matrix.size() >= Cholesky::kSupernodalFrom ? CHOLMOD_SUPERNODAL : CHOLMOD_SIMPLICIAL;
  cholmod_free_factor(&s.factor, &s.common);
  s.factor = symbolic_factor(matrix, s.ordering, s.common);
  s.permute_pattern(matrix);
}

bool Cholesky::factorize(const SparseSymmetric& matrix, double shift) {
  State& s = *state_;
  cholmod_sparse a = s.permuted(matrix);
  double beta[2] = {shift, 0};
  const auto lock = lock_blas(*s.factor);
  cholmod_factorize_p(&a, beta, nullptr, 0, s.factor, &s.common);
  if (s.common.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
  s.factorized = s.common.status == CHOLMOD_OK && s.factor->minor == s.factor->n;
  return s.factorized;
}

bool Cholesky::is_analyzed() const { return state_->factor != nullptr; }
bool Cholesky::has_factor() const { return state_->factorized; }

Eigen::VectorXd Cholesky::solve(const Eigen::VectorXd& right_hand_side) {
  State& s = *state_;
  const Eigen::Map<const Eigen::VectorXi> permutation(static_cast<const int*>(s.factor->Perm),
                                                      right_hand_side.size());
  s.right_hand_side = right_hand_side(permutation);
  triangular_solve(*s.factor, s.right_hand_side, s.work);
  Eigen::VectorXd solution(right_hand_side.size());
  solution(permutation) = s.right_hand_side;
  return solution;
}

}  // namespace foldless
