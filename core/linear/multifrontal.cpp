// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/multifrontal.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <vector>

#include "core/linear/dense_cholesky.h"
#include "core/linear/dense_kernels.h"
#include "core/linear/front_panels.h"
#include "core/linear/single_precision_solve.h"
#include "core/threads/team.h"

namespace foldless {
namespace {

/// A panel and an update matrix, which together are a lower triangle.
template <class Value>
struct Front {
  DensePanel<Value> panel;
  Value* update;  ///< below × below
  int below;

  /// The values of a column of the front, by rows of the front.
  Value* column(int j) const {
    return j < panel.columns
               ? panel.value + static_cast<std::ptrdiff_t>(j) * panel.rows
               : update + static_cast<std::ptrdiff_t>(j - panel.columns) * below - panel.columns;
  }
};

struct NodesOfFront {
  int begin, end;
};

/// Where a front works.
template <class Value>
struct Workplace {
  Value* updates;              ///< `update_start` of a supernode counts from here,
  Value* updates_of_children;  ///< and that of its children from here
  Value* panel;                ///< room for it, where it does not stay
};

/// Room for the update matrices of one subtree and for a panel for each thread, so that it is used
/// again while it is in the thread's cache.
template <class Value>
class SubtreeRooms {
 public:
  SubtreeRooms(Value* room, std::size_t size, int count) {
    for (int i = count - 1; i >= 0; --i) free_.push_back(room + static_cast<std::size_t>(i) * size);
  }
  Value* take() {
    const std::scoped_lock lock(guard_);
    Value* room = free_.back();
    free_.pop_back();
    return room;
  }
  void give_back(Value* room) {
    const std::scoped_lock lock(guard_);
    free_.push_back(room);
  }

 private:
  std::mutex guard_;
  std::vector<Value*> free_;
};

/// As many as subtrees can be worked on at once.
int rooms_of_subtrees(const SymbolicFactor& factor) {
  const int threads = present_team() ? present_team()->size() : 1;
  return std::min(threads, static_cast<int>(factor.subtrees.size()));
}

/// Columns of a square that are worth handing out together: some tens of thousands of values.
int columns_together(int rows) { return 2 * std::max(8, 16384 / std::max(rows, 1)); }

template <class Panels>
class Multifrontal {
 public:
  using Value = typename Panels::Value;

  // NOLINTNEXTLINE(readability-function-size): what is factorized, and where to
  Multifrontal(const SymbolicFactor& factor, const SparseSymmetric& matrix, double shift,
               const Panels& panels, Buffer<std::byte>& room, const std::stop_token& token)
      : factor_(factor),
        matrix_(matrix),
        shift_(shift),
        panels_(panels),
        updates_(values_in(room, factor, panels)),
        panel_(updates_ + factor.updates),
        rooms_(panel_ + panels.room(), room_of_subtree(factor, panels), rooms_of_subtrees(factor)),
        token_(token),
        first_failure_(factor.size()) {}

  int run() {
    const std::vector<Subtree>& subtrees = factor_.subtrees;
    in_parallel(static_cast<int>(subtrees.size()),
                [&](int i) { ends_at(run_subtree(subtrees[static_cast<std::size_t>(i)])); });
    int first = first_failure_;
    for (std::size_t i = 0; i < factor_.top.size() && first == factor_.size(); ++i)
      first = eliminate(static_cast<std::size_t>(factor_.top[i]), {updates_, updates_, panel_});
    return first;
  }

 private:
  static std::size_t room_of_subtree(const SymbolicFactor& factor, const Panels& panels) {
    return panels.room() + factor.subtree_updates;
  }

  static Value* values_in(Buffer<std::byte>& room, const SymbolicFactor& factor,
                          const Panels& panels) {
    const auto subtrees = static_cast<std::size_t>(rooms_of_subtrees(factor));
    room.reserve(sizeof(Value) *
                 (factor.updates + panels.room() + subtrees * room_of_subtree(factor, panels)));
    return reinterpret_cast<Value*>(room.data());
  }

  /// The number of columns, or the first whose pivot is not positive.
  int run_subtree(const Subtree& subtree) {
    Value* panel = rooms_.take();
    Value* stack = panel + panels_.room();
    int found = factor_.size();
    for (int k = subtree.first; k < subtree.root && found == factor_.size(); ++k)
      found = eliminate(static_cast<std::size_t>(k), {stack, stack, panel});
    if (found == factor_.size())
      found = eliminate(static_cast<std::size_t>(subtree.root), {updates_, stack, panel});
    rooms_.give_back(panel);
    return found;
  }

  /// Says where a subtree ended: where it failed, those that have later columns need not go on.
  void ends_at(int column) {
    int first = first_failure_.load(std::memory_order_relaxed);
    while (column < first &&
           !first_failure_.compare_exchange_weak(first, column, std::memory_order_relaxed)) {
    }
  }

  /// The same, of one supernode.
  int eliminate(std::size_t k, const Workplace<Value>& at) const {
    const Supernode& s = factor_.supernodes[k];
    if (token_.stop_requested() || s.first >= first_failure_.load(std::memory_order_relaxed))
      return s.first;
    const Front<Value> front = {
        {panels_.place(s, at.panel), s.rows(), s.columns}, at.updates + s.update_start, s.below};
    const DenseKernels<Value>& kernels = dense_kernels<Value>();
    clear(front.panel);
    add_matrix(k, front.panel);
    if (s.child >= 0) add_updates(s, front, at.updates_of_children);
    const int found = factorize_panel(front.panel, kernels);
    if (found < s.columns) return s.first + found;
    if (s.below > 0)
      subtract_square(front.panel, front.update,
                      s.child >= 0 ? Square::accumulate : Square::from_zero, kernels);
    panels_.keep(s, front.panel.value);
    return factor_.size();
  }

  static void clear(const DensePanel<Value>& panel) {
    constexpr std::ptrdiff_t kValuesTogether = 65'536;
    in_ranges(static_cast<std::ptrdiff_t>(panel.rows) * panel.columns, kValuesTogether,
              [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
                std::fill(panel.value + begin, panel.value + end, Value{0});
              });
  }

  void add_matrix(std::size_t k, const DensePanel<Value>& panel) const {
    const Supernode& s = factor_.supernodes[k];
    const double* value = matrix_.value.data();
    for (int j = 0; j < s.columns; j += 2) {
      const auto node =
          static_cast<std::size_t>(factor_.order[static_cast<std::size_t>((s.first + j) / 2)]);
      const double* first = value + matrix_.first_column(node);
      Value* target = panel.value + static_cast<std::ptrdiff_t>(j) * (panel.rows + 1);
      target[0] = static_cast<Value>(first[0] + shift_);
      target[1] = static_cast<Value>(first[1]);
      target[panel.rows + 1] = static_cast<Value>(value[matrix_.second_column(node)] + shift_);
    }
    const std::size_t end = k + 1 < factor_.supernodes.size()
                                ? factor_.supernodes[k + 1].block_start
                                : factor_.blocks.size();
    for (std::size_t b = s.block_start; b < end; ++b) {
      const BlockOfPanel& block = factor_.blocks[b];
      const double *first = value + block.first, *second = value + block.second;
      const bool is_transposed = block.target < 0;
      Value* target = panel.value + (is_transposed ? ~block.target : block.target);
      target[0] = static_cast<Value>(first[0]);
      target[1] = static_cast<Value>(is_transposed ? second[0] : first[1]);
      target[panel.rows] = static_cast<Value>(is_transposed ? first[1] : second[0]);
      target[panel.rows + 1] = static_cast<Value>(second[1]);
    }
  }

  void add_updates(const Supernode& s, const Front<Value>& front, const Value* of_children) const {
    in_ranges(s.below, columns_together(s.below), [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
      for (std::ptrdiff_t j = begin; j < end; ++j) {
        const std::ptrdiff_t from = j & ~3;  // the kernels take whole blocks on the diagonal
        std::fill_n(front.update + j * s.below + from, s.below - from, Value{0});
      }
    });
    for (int k = s.child; k >= 0;) {
      const Supernode& child = factor_.supernodes[static_cast<std::size_t>(k)];
      in_ranges(child.below / 2, columns_together(child.below) / 2,
                [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
                  add_update(child, of_children + child.update_start, front,
                             {static_cast<int>(begin), static_cast<int>(end)});
                });
      k = child.sibling;
    }
  }

  /// The columns of some nodes of the update matrix of a child.
  void add_update(const Supernode& child, const Value* update, const Front<Value>& front,
                  NodesOfFront nodes) const {
    const std::span<const int> places = factor_.places_of(child);
    const int* place = places.data();
    const Value* a = update + static_cast<std::ptrdiff_t>(2 * nodes.begin) * child.below;
    for (int j = 2 * nodes.begin; j < 2 * nodes.end; j += 2) {
      const Value* b = a + child.below;
      Value* to_a = front.column(2 * place[j / 2]);
      Value* to_b = front.column(2 * place[j / 2] + 1);
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
  const Panels& panels_;
  Value* updates_;
  Value* panel_;  ///< room for those above the subtrees
  SubtreeRooms<Value> rooms_;
  const std::stop_token& token_;
  std::atomic<int> first_failure_;
};

}  // namespace

// NOLINTNEXTLINE(readability-function-size): what is factorized, and where to
int factorize(const SymbolicFactor& factor, const SparseSymmetric& matrix, double shift,
              double* values, Buffer<std::byte>& room, const std::stop_token& token) {
  const KeptPanels panels(values);
  return Multifrontal(factor, matrix, shift, panels, room, token).run();
}

// NOLINTNEXTLINE(readability-function-size): the same
int factorize(const SymbolicFactor& factor, const SparseSymmetric& matrix, double shift,
              float* single, Buffer<std::byte>& room, const std::stop_token& token) {
  const auto keep = [&](const Supernode& s, const double* panel) {
    to_single_precision(s, panel, single + s.value_start);
  };
  const RoundedPanels<double, decltype(keep)> panels(factor, keep);
  return Multifrontal(factor, matrix, shift, panels, room, token).run();
}

// NOLINTNEXTLINE(readability-function-size): the same
int factorize(const SymbolicFactor& factor, const SparseSymmetric& matrix, double shift,
              HalfFactor& half, Buffer<std::byte>& room, const std::stop_token& token) {
  make_room(factor, half);
  const auto keep = [&](const Supernode& s, const float* panel) {
    round_panel(factor, s, panel, half);
  };
  const RoundedPanels<float, decltype(keep)> panels(factor, keep);
  return Multifrontal(factor, matrix, shift, panels, room, token).run();
}

}  // namespace foldless
