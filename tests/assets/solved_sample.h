// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "assets/make/sample_meshes.h"
#include "assets/make/sample_scenes.h"
#include "core/run/run.h"

namespace foldless::test {

/// How a sample ended under one method.
struct Ending {
  bool satisfied = false;
  std::optional<Outcome> outcome;
  Iteration last;
  std::vector<Iteration> iterations;
};

inline Problem sample(const std::string& name, const std::string& method) {
  const auto all = samples::sample_scenes(samples::sample_meshes());
  const Scene& scene = std::find_if(all.begin(), all.end(), [&](const samples::SampleScene& s) {
                         return s.name == name;
                       })->scene;
  Problem problem{MeshPair(scene.triangles, scene.rest), scene.energy, scene.handles,
                  scene.parameters};
  problem.parameters.method = method;
  return problem;
}

inline Ending solved(const Problem& problem) {
  Run run(problem);
  Ending ending;
  while (const auto iteration = run.step({})) ending.iterations.push_back(*iteration);
  if (!ending.iterations.empty()) ending.last = ending.iterations.back();
  ending.satisfied = run.is_satisfied();
  ending.outcome = run.outcome();
  return ending;
}

inline Ending solved(const std::string& name, const std::string& method) {
  return solved(sample(name, method));
}

}  // namespace foldless::test
