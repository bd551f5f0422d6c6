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

std::vector<int> components_of(const MeshPair& mesh) {
  Components components(mesh.vertex_count());
  for (const auto& t : mesh.triangles().colwise()) {
    components.join(t[0], t[1]);
    components.join(t[1], t[2]);
  }
  std::vector<int> component;
  for (int v = 0; v < mesh.vertex_count(); ++v) component.push_back(components.root(v));
  return component;
}

Unknowns unknowns_of(const MeshPair& mesh, const std::vector<int>& handle_vertices) {
  const auto count = static_cast<std::size_t>(mesh.vertex_count());
  const std::vector<int> component = components_of(mesh);
  std::vector<bool> used(count, false);
  for (const int v : mesh.triangles().reshaped()) used[static_cast<std::size_t>(v)] = true;
  std::vector<bool> held(count, false);
  for (const int v : handle_vertices)
    held[static_cast<std::size_t>(component[static_cast<std::size_t>(v)])] = true;

  Unknowns unknowns;
  unknowns.node_of_vertex.assign(count, -1);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const auto i = static_cast<std::size_t>(v);
    if (!used[i] || !held[static_cast<std::size_t>(component[i])]) continue;
    unknowns.node_of_vertex[i] = unknowns.count();
    unknowns.vertex_of_node.push_back(v);
  }
  return unknowns;
}

}  // namespace foldless
