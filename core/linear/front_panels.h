// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>

#include "core/linear/symbolic_factor.h"

namespace foldless {

/// Panels of a factor in double precision, which are made where they stay.
class KeptPanels {
 public:
  using Value = double;
  explicit KeptPanels(double* values) : values_(values) {}
  static std::size_t room() { return 0; }
  double* place(const Supernode& s, double* /*room*/) const { return values_ + s.value_start; }
  static void keep(const Supernode& /*s*/, const double* /*panel*/) {}

 private:
  double* values_;
};

inline std::size_t size_of_largest_panel(const SymbolicFactor& factor) {
  std::size_t size = 0;
  for (const Supernode& s : factor.supernodes)
    size = std::max(size, static_cast<std::size_t>(s.rows()) * static_cast<std::size_t>(s.columns));
  return size;
}

/// Those that are kept in less precision, each made in its thread's room. Keep: takes a supernode
/// and its panel.
template <class Made, class Keep>
class RoundedPanels {
 public:
  using Value = Made;
  RoundedPanels(const SymbolicFactor& factor, const Keep& keep)
      : keep_(keep), room_(size_of_largest_panel(factor)) {}
  std::size_t room() const { return room_; }
  static Value* place(const Supernode& /*s*/, Value* room) { return room; }
  void keep(const Supernode& s, const Value* panel) const { keep_(s, panel); }

 private:
  const Keep& keep_;
  std::size_t room_;
};

}  // namespace foldless
