// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/scale_suite.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "core/energy/densities.h"
#include "core/mesh/generate.h"

namespace foldless {
namespace {

enum class ScaleKind { bend, twist, mild };

struct SizeOfKind {
  ScaleKind kind;
  int faces;
};
/// By index. New ones come last, so that an index stays with its scene.
constexpr std::array<SizeOfKind, kScaleScenes> kScenes{{{ScaleKind::bend, 2000},
                                                        {ScaleKind::bend, 20000},
                                                        {ScaleKind::bend, 100000},
                                                        {ScaleKind::bend, 400000},
                                                        {ScaleKind::twist, 2000},
                                                        {ScaleKind::twist, 20000},
                                                        {ScaleKind::twist, 100000},
                                                        {ScaleKind::twist, 400000},
                                                        {ScaleKind::mild, 1000000},
                                                        {ScaleKind::bend, 1000000},
                                                        {ScaleKind::twist, 1000000},
                                                        {ScaleKind::mild, 2000000}}};

constexpr double kLength = 4;  ///< of the bar, whose width is 1
constexpr double kStrongBend = 120 * std::numbers::pi / 180;
constexpr double kMildBend = 20 * std::numbers::pi / 180;
constexpr double kTwist = 150 * std::numbers::pi / 180;

BenchScene scene_over(std::string name, const Shape& shape, const char* energy) {
  BenchScene scene;
  scene.name = std::move(name);
  scene.scene.triangles = shape.triangles;
  scene.scene.rest = shape.rest;
  scene.scene.energy = find_density(energy);
  return scene;
}

void add_handle(Scene& scene, int vertex, const Vec2& target) {
  scene.handles.push_back({static_cast<int>(scene.handles.size()) + 1, vertex, target});
}

/// The left end of a bar is held, the right end goes where it would lie if the middle line were an
/// arc of a circle of the same length.
BenchScene bend(const std::string& name, int faces, double angle) {
  const int cells = static_cast<int>(std::lround(std::sqrt(faces / (2 * kLength))));
  BenchScene scene = scene_over(name, bar(kLength, 1, cells), "arap");
  const Points& rest = scene.scene.rest;
  const double left = rest.row(0).minCoeff(), right = rest.row(0).maxCoeff();
  const double middle = rest.row(1).mean(), radius = kLength / angle;
  for (int v = 0; v < rest.cols(); ++v) {
    const Vec2 p = rest.col(v);
    if (p.x() == left) add_handle(scene.scene, v, p);
    if (p.x() != right) continue;
    const double r = radius + p.y() - middle;
    add_handle(scene.scene, v, {left + r * std::sin(angle), middle - radius + r * std::cos(angle)});
  }
  return scene;
}

/// The boundary of a disk is held, the ring half way to it turns.
BenchScene twist(const std::string& name, int faces) {
  const int rings = static_cast<int>(std::lround(std::sqrt(faces / 6.0)));
  const DiskOptions options{rings, 6 * rings, 1 + 3 * rings * (rings + 1), 1};
  BenchScene scene = scene_over(name, disk(options), "dirichlet");
  const Points& rest = scene.scene.rest;
  for (const int v : disk_ring(options, rings)) add_handle(scene.scene, v, rest.col(v));
  for (const int v : disk_ring(options, rings / 2))
    add_handle(scene.scene, v, Eigen::Rotation2Dd(kTwist) * rest.col(v));
  return scene;
}

/// p of seconds ~ F^p.
double growth(const BenchRow& smaller, const BenchRow& larger) {
  return std::log(larger.seconds / smaller.seconds) /
         std::log(static_cast<double>(larger.faces) / smaller.faces);
}

std::string size_words(int faces) { return std::to_string(faces / 1000) + "k"; }

}  // namespace

BenchScene scale_scene(int index) {
  const auto [kind, faces] = kScenes[static_cast<std::size_t>(index)];
  switch (kind) {
    case ScaleKind::bend: return bend("bend-" + size_words(faces), faces, kStrongBend);
    case ScaleKind::twist: return twist("twist-" + size_words(faces), faces);
    case ScaleKind::mild: break;
  }
  return bend("mild-" + size_words(faces), faces, kMildBend);
}

TextTable scale_table(std::span<const BenchRow> rows) {
  TextTable table(
      {"scene", "V/F", "method", "reached", "H/U", "CPU s", "s/H", "growth", "max", "valid"});
  std::map<std::string, const BenchRow*> before;  // of a kind of scene and a method
  for (const BenchRow& row : rows) {
    const std::string kind = row.scene.substr(0, row.scene.find('-'));
    const BenchRow*& smaller = before[kind + ' ' + row.method];
    const int factorizations = std::max(1, row.last.factorizations);
    table.add({row.scene, std::to_string(row.vertices) + '/' + std::to_string(row.faces),
               row.method, row.has_reached() ? "yes" : row.outcome,
               std::to_string(row.last.factorizations) + '/' + std::to_string(row.last.updates),
               number_text(row.seconds), number_text(row.seconds / factorizations),
               smaller ? number_text(growth(*smaller, row), 2) : "",
               number_text(row.max_conformal_distortion), row.is_valid ? "yes" : "no"});
    smaller = &row;
  }
  return table;
}

}  // namespace foldless
