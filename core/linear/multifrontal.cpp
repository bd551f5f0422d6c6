// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/multifrontal.h"

#include <algorithm>

#include "core/linear/dense_cholesky.h"
#include "core/linear/dense_kernels.h"

namespace foldless {
namespace {

/// A panel and an update matrix, which together are a lower triangle.
struct Front {
  DensePanel panel;
  double* update;  ///< below × below
  int below;

  /// The values of a column of the front, by rows of the front.
  double* column(int j) const {
    return j < panel.columns
               ? panel.value + static_cast<std::ptrdiff_t>(j) * panel.rows
               : update + static_cast<std::ptrdiff_t>(j - panel.columns) * below - panel.columns;
  }
};

class Multifrontal {
 public:
  Multifrontal(const SymbolicFactor& factor, const SparseSymmetric& matrix, double shift,
               double* values, UpdateStacks& stacks)
      : factor_(factor), matrix_(matrix), shift_(shift), values_(values), stacks_(stacks) {}

  int run() {
    const DenseKernels& kernels = dense_kernels();
    for (std::size_t k = 0; k < factor_.supernodes.size(); ++k) {
      const Supernode& s = factor_.supernodes[k];
      const Front front = front_of(s);
      std::fill_n(front.panel.value, static_cast<std::size_t>(s.rows()) * s.columns, 0.0);
      add_matrix(k, front.panel);
      if (s.child >= 0) add_updates(s, front);
      const int found = factorize_panel(front.panel, kernels);
      if (found < s.columns) return s.first + found;
      if (s.below > 0)
        subtract_square(front.panel, front.update,
                        s.child >= 0 ? Square::accumulate : Square::from_zero, kernels);
    }
    return factor_.size();
  }

 private:
  Front front_of(const Supernode& s) const {
    return {{values_ + s.value_start, s.rows(), s.columns},
            stacks_.stack[s.update_stack].data() + s.update_start,
            s.below};
  }

  void add_matrix(std::size_t k, const DensePanel& panel) const {
    const Supernode& s = factor_.supernodes[k];
    const double* value = matrix_.value.data();
    for (int j = 0; j < s.columns; j += 2) {
      const auto node =
          static_cast<std::size_t>(factor_.order[static_cast<std::size_t>((s.first + j) / 2)]);
      const double* first = value + matrix_.column_start[2 * node];
      double* target = panel.value + static_cast<std::ptrdiff_t>(j) * (panel.rows + 1);
      target[0] = first[0] + shift_;
      target[1] = first[1];
      target[panel.rows + 1] = value[matrix_.column_start[2 * node + 1]] + shift_;
    }
    const std::size_t end = k + 1 < factor_.supernodes.size()
                                ? factor_.supernodes[k + 1].block_start
                                : factor_.blocks.size();
    for (std::size_t b = s.block_start; b < end; ++b) {
      const BlockOfPanel& block = factor_.blocks[b];
      const double *first = value + block.first, *second = value + block.second;
      const bool is_transposed = block.target < 0;
      double* target = panel.value + (is_transposed ? ~block.target : block.target);
      target[0] = first[0];
      target[1] = is_transposed ? second[0] : first[1];
      target[panel.rows] = is_transposed ? first[1] : second[0];
      target[panel.rows + 1] = second[1];
    }
  }

  void add_updates(const Supernode& s, const Front& front) const {
    for (int j = 0; j < s.below; ++j) {
      const int from = j & ~3;  // the kernels take whole blocks on the diagonal
      std::fill_n(front.update + static_cast<std::ptrdiff_t>(j) * s.below + from, s.below - from,
                  0.0);
    }
    for (int k = s.child; k >= 0;) {
      const Supernode& child = factor_.supernodes[static_cast<std::size_t>(k)];
      add_update(child, front);
      k = child.sibling;
    }
  }

  void add_update(const Supernode& child, const Front& front) const {
    const std::span<const int> places = factor_.places_of(child);
    const int* place = places.data();
    const double* a = front_of(child).update;
    for (int j = 0; j < child.below; j += 2) {
      const double* b = a + child.below;
      double* to_a = front.column(2 * place[j / 2]);
      double* to_b = front.column(2 * place[j / 2] + 1);
      for (int i = j; i < child.below; i += 2) {
        const int row = 2 * place[i / 2];
        to_a[row] += a[i];
        to_a[row + 1] += a[i + 1];
        to_b[row] += b[i];
        to_b[row + 1] += b[i + 1];
      }
      a = b + child.below;
    }
  }

  const SymbolicFactor& factor_;
  const SparseSymmetric& matrix_;
  double shift_;
  double* values_;
  UpdateStacks& stacks_;
};

}  // namespace

// NOLINTNEXTLINE(readability-function-size): what is factorized, and where to
int factorize(const SymbolicFactor& factor, const SparseSymmetric& matrix, double shift,
              double* values, UpdateStacks& stacks) {
  for (int i = 0; i < 2; ++i) stacks.stack[i].reserve(factor.stack_sizes[i]);
  return Multifrontal(factor, matrix, shift, values, stacks).run();
}

}  // namespace foldless
