// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/target_tolerance.h"

#include <utility>

namespace foldless {

double TargetTolerance::of(const Document& document) {
  if (document.is_empty()) return 0;
  std::vector<int> vertices;
  vertices.reserve(document.handles.size());
  for (const Handle& handle : document.handles) vertices.push_back(handle.vertex);
  const Snapshot& pose = *document.pose;
  if (pose.triangles == triangles_ && pose.rest == rest_ && vertices == vertices_) return value_;
  triangles_ = pose.triangles;
  rest_ = pose.rest;
  vertices_ = std::move(vertices);
  value_ = target_tolerance(document);
  return value_;
}

}  // namespace foldless
