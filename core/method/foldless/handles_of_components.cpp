// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/handles_of_components.h"

#include <map>
#include <utility>

#include "core/mesh/components.h"

namespace foldless {

std::vector<std::vector<int>> handles_of_components(const MeshPair& mesh,
                                                    const Constraints& constraints) {
  const std::vector<int> components = components_of(mesh.triangles(), mesh.vertex_count());
  std::map<int, std::vector<int>> by_component;
  for (int i = 0; i < constraints.count(); ++i) {
    const int v = constraints.vertices[static_cast<std::size_t>(i)];
    by_component[components[static_cast<std::size_t>(v)]].push_back(i);
  }
  std::vector<std::vector<int>> handles;
  handles.reserve(by_component.size());
  for (auto& [component, of_component] : by_component) handles.push_back(std::move(of_component));
  return handles;
}

}  // namespace foldless
