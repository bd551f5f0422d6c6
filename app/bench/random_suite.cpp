// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/random_suite.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/energy/densities.h"

namespace foldless {
namespace {

// 5 energies and 6 difficulties have no common factor: 30 scenes in a row have every pair once.
const Density& energy_of(int index) {
  return densities()[static_cast<std::size_t>(index) % densities().size()];
}

const Difficulty& difficulty_of(int index) {
  return difficulties()[static_cast<std::size_t>(index) % difficulties().size()];
}

std::string name_of(std::uint64_t seed, int index, const std::string& mesh) {
  std::string number = std::to_string(index);
  if (number.size() < 3) number.insert(0, 3 - number.size(), '0');
  return "seed" + std::to_string(seed) + "-" + number + "-" + mesh + "-" +
         std::string(energy_of(index).name) + "-" + std::string(difficulty_of(index).name);
}

/// True when a handle goes anywhere: small moves in a narrow mesh may miss every vertex.
bool has_work(const RandomDeformation& deformation) {
  return std::ranges::any_of(deformation.handles, [&](int v) {
    const Vec2 p = deformation.mesh.shape.rest.col(v);
    return (deformation.map(p) - p).norm() > 0.02 * deformation.mesh.diagonal;
  });
}

}  // namespace

RandomDeformation random_deformation(std::uint64_t seed, int index) {
  // Two rounds, so that neighbouring seeds and indices share nothing.
  RandomNumbers random(RandomNumbers(seed).next() ^ static_cast<std::uint64_t>(index));
  while (true) {
    RandomDeformation deformation;
    deformation.mesh = random_mesh(random);
    if (difficulty_of(index).draw(random, deformation) && has_work(deformation)) return deformation;
  }
}

BenchScene random_scene(std::uint64_t seed, int index) {
  const RandomDeformation deformation = random_deformation(seed, index);
  BenchScene result;
  result.name = name_of(seed, index, deformation.mesh.name);
  result.difficulty = difficulty_of(index).name;
  Scene& scene = result.scene;
  scene.triangles = deformation.mesh.shape.triangles;
  scene.rest = deformation.mesh.shape.rest;
  scene.energy = &energy_of(index);
  scene.description = result.name;
  for (const int v : deformation.handles) {
    const Vec2 rest = scene.rest.col(v);
    const Vec2 target = deformation.map(rest).unaryExpr(&suite_coordinate);
    const HandleKind kind = target == rest ? HandleKind::pin : HandleKind::drag;
    scene.handles.push_back({static_cast<int>(scene.handles.size()) + 1, v, target, kind});
  }
  return result;
}

}  // namespace foldless
