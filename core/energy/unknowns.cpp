// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/unknowns.h"

#include <numeric>

namespace foldless {
namespace {

/// Disjoint sets of vertices with path halving.
class Components {
 public:
  explicit Components(int count) : parent_(static_cast<std::size_t>(count)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int root(int v) {
    while (at(v) != v) v = at(v) = at(at(v));
    return v;
  }
  void join(int a, int b) { at(root(a)) = root(b); }

 private:
  int& at(int v) { return parent_[static_cast<std::size_t>(v)]; }
  std::vector<int> parent_;
};

}  // namespace

Unknowns unknowns_of(const MeshPair& mesh, const std::vector<int>& handle_vertices) {
  const auto count = static_cast<std::size_t>(mesh.vertex_count());
  Components components(mesh.vertex_count());
  std::vector<bool> used(count, false);
  for (const auto& t : mesh.triangles().colwise()) {
    components.join(t[0], t[1]);
    components.join(t[1], t[2]);
    for (int corner = 0; corner < 3; ++corner) used[static_cast<std::size_t>(t[corner])] = true;
  }
  std::vector<bool> held(count, false);
  for (const int v : handle_vertices) held[static_cast<std::size_t>(components.root(v))] = true;

  Unknowns unknowns;
  unknowns.node_of_vertex.assign(count, -1);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const auto i = static_cast<std::size_t>(v);
    if (!used[i] || !held[static_cast<std::size_t>(components.root(v))]) continue;
    unknowns.node_of_vertex[i] = unknowns.count();
    unknowns.vertex_of_node.push_back(v);
  }
  return unknowns;
}

}  // namespace foldless
