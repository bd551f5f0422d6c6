// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/components.h"

#include <numeric>

namespace foldless {
namespace {

/// Disjoint sets of vertices with path halving.
class DisjointSets {
 public:
  explicit DisjointSets(int count) : parent_(static_cast<std::size_t>(count)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int root(int v) {
    while (at(v) != v) v = at(v) = at(at(v));
    return v;
  }
  void join(int a, int b) {
    if (at(a) != at(b)) at(root(a)) = root(b);  // most are joined already
  }

 private:
  int& at(int v) { return parent_[static_cast<std::size_t>(v)]; }
  std::vector<int> parent_;
};

}  // namespace

std::vector<int> components_of(const Triangles& triangles, int vertices) {
  DisjointSets sets(vertices);
  for (const auto& t : triangles.colwise()) {
    sets.join(t[0], t[1]);
    sets.join(t[1], t[2]);
  }
  std::vector<int> component;
  component.reserve(static_cast<std::size_t>(vertices));
  for (int v = 0; v < vertices; ++v) component.push_back(sets.root(v));
  return component;
}

}  // namespace foldless
