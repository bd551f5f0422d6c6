// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/triangle.h"
#include "tests/fuzz/input.h"
#include "tests/judge/judge.h"

namespace foldless::fuzz {

inline judge::Mesh judged(const Triangles& triangles, const Points& points) {
  judge::Mesh mesh;
  for (const auto& p : points.colwise()) mesh.points.push_back({p.x(), p.y()});
  for (const auto& t : triangles.colwise()) mesh.triangles.push_back({t[0], t[1], t[2]});
  return mesh;
}

/// By the judge, who shares no code with the program.
inline void expect_judged_injective(const Triangles& triangles, const Points& points) {
  for (const std::string& objection : judge::objections_to(judged(triangles, points)))
    expect(false, objection);
}

}  // namespace foldless::fuzz
