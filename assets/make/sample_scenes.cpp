// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/sample_scenes.h"

#include <algorithm>
#include <string_view>

#include "assets/make/place_handles.h"
#include "assets/make/sample_animations.h"
#include "core/outline/shapes.h"

namespace foldless::samples {
namespace {

/// A disk with its boundary held and one ring turned about the centre.
struct DiskTurn {
  int ring;
  double degrees;
};

Scene turned_disk(Scene scene, const DiskOptions& options, const DiskTurn& disk_turn) {
  pin(scene, disk_ring(options, options.rings));
  turn(scene, disk_ring(options, disk_turn.ring), Vec2::Zero(), disk_turn.degrees);
  return scene;
}

constexpr DiskTurn kCoarseTurn{5, 140};
constexpr DiskTurn kDenseTurn{8, 160};

/// The samples that are made from one mesh, found by name.
class Meshes {
 public:
  explicit Meshes(const std::vector<SampleMesh>& meshes) : meshes_(meshes) {}
  const SampleMesh& at(std::string_view name) const {
    return *std::find_if(meshes_.begin(), meshes_.end(),
                         [&](const SampleMesh& mesh) { return mesh.name == name; });
  }

 private:
  const std::vector<SampleMesh>& meshes_;
};

Scene welcome(const Meshes& meshes) {
  Scene scene = scene_over(meshes.at("gingerbread"), "arap",
                           "Drag a hand, a foot or the head: the mesh follows and never folds.");
  for (const Vec2& p :
       {Vec2(-1.02, 1.46), Vec2(1.02, 1.46), Vec2(-0.55, 0.22), Vec2(0.55, 0.22), Vec2(0, 2.15)}) {
    const int v = nearest_vertex(scene, p);
    add_handle(scene, v, scene.rest.col(v));
  }
  scene.parameters.method = "foldless";
  return scene;
}

Scene blocked_edge(const Meshes& meshes) {
  Scene scene = scene_over(
      meshes.at("grid_coarse"), "arap",
      "One vertex must pass an edge whose ends are held: flipping that edge lets it through.");
  const auto vertex = [](int i, int j) { return j * (kCoarseGrid.columns + 1) + i; };
  pin(scene, {vertex(3, 2), vertex(3, 3), vertex(4, 3)});
  const Points& rest = scene.rest;
  const Vec2 beyond =
      (rest.col(vertex(3, 2)) + rest.col(vertex(3, 3)) + rest.col(vertex(4, 3))) / 3;
  add_handle(scene, vertex(2, 2), beyond);
  return scene;
}

Scene relaxed_disk(const Meshes& meshes) {
  Scene scene = turned_disk(
      scene_over(meshes.at("disk_coarse"), "lscm",
                 "Step to the fourth update, then on: relaxation gives the crushed triangles their "
                 "shape back."),
      kCoarseDisk, kCoarseTurn);
  scene.parameters.method = "paper-noflip";
  return scene;
}

Scene flipped_bar(const Meshes& meshes) {
  Scene scene = scene_over(
      meshes.at("bar_with_hole"), "arap",
      "Show the flipped edges (key 6): they gather on the inside of the bend, above the hole.");
  pin_at(scene, {{-1.4, -0.35}, {-1.4, 0}, {-1.4, 0.35}});
  for (const double y : {-0.35, 0.0, 0.35}) {
    const int v = nearest_vertex(scene, {1.4, y});
    add_handle(scene, v, turned(scene.rest.col(v), {0.0, 0.8}, 140));
  }
  return scene;
}

Scene coarse_disk(const Meshes& meshes) {
  return turned_disk(scene_over(meshes.at("disk_coarse"), "lscm",
                                "The inner ring turns by 140 degrees: compare the factorizations "
                                "with and without flips."),
                     kCoarseDisk, kCoarseTurn);
}

Scene dense_disk(const Meshes& meshes) {
  return turned_disk(scene_over(meshes.at("disk_dense"), "dirichlet",
                                "The inner ring turns by 160 degrees: watch the spiral wind up "
                                "between the rings."),
                     kDenseDisk, kDenseTurn);
}

Scene dense_disk_with_eta(const Meshes& meshes, double eta) {
  Scene scene = dense_disk(meshes);
  scene.parameters.eta = eta;
  scene.description =
      "The smaller eta, the more edges flip: compare the rest meshes of 10 %, 1 % and 0.1 %.";
  return scene;
}

Scene coarse_disk_with_delta(const Meshes& meshes, double delta) {
  Scene scene = coarse_disk(meshes);
  scene.parameters.delta = delta;
  scene.description =
      "No triangle shrinks below delta times its area: compare the smallest ones of 1e-5, 1e-3 "
      "and 1e-1.";
  return scene;
}

Scene alligator_bends(const Meshes& meshes) {
  Scene scene = scene_over(
      meshes.at("alligator"), "green-strain",
      "The tail curls over the back and the jaws gape: under Green strain scutes and teeth "
      "keep their size.");
  pin_at(scene, {{-0.75, 0.05}, {0.6, 0.05}});
  drag(scene, {2.5, 0.99}, {1.5, 2.3});
  drag(scene, {2.42, 0.45}, {2.6, 0.1});
  drag(scene, {-2.6, 0.58}, {-0.9, 1.9});
  scene.parameters.delta = 0.1;
  scene.parameters.eta = 1e-2;
  return scene;
}

Scene cowboy_waves(const Meshes& meshes) {
  Scene scene = scene_over(
      meshes.at("cowboy"), "arap",
      "The belly turns by 120 degrees as the puppet jumps: flips spread the twist and save "
      "factorizations.");
  turn(scene, vertices_near(scene, {0, 1.3}, 0.26), {0, 1.3}, 120);
  drag(scene, {-0.6, 0.1}, {-1.8, 1.1});
  drag(scene, {0.6, 0.1}, {1.3, -0.2});
  drag(scene, {-1.1, 1.3}, {-1.7, 2.1});
  drag(scene, {1.1, 1.3}, {1.9, 1.9});
  drag(scene, {-0.35, 2.7}, {-0.2, 3.5});
  drag(scene, {0.35, 2.7}, {0.55, 3.35});
  drag(scene, {0, 2.1}, {0.15, 2.2});
  scene.parameters.delta = 1e-3;
  scene.parameters.eta = 1e-2;
  return scene;
}

Scene smooth_sequence(const Meshes& meshes) {
  Scene scene = dense_disk(meshes);
  scene.description =
      "Drag through the timeline: no shape is far from the one before, and none is folded.";
  return scene;
}

Scene turned_dense_grid(const Meshes& meshes) {
  Scene scene = scene_over(meshes.at("grid_dense"), "lscm",
                           "A block of a held grid turns by 170 degrees: with flips only.");
  pin(scene, grid_square(kDenseGrid, 0, kDenseGrid.columns, true));
  turn(scene, grid_square(kDenseGrid, 2, 6, false), {0.4, 0.4}, 170);
  scene.parameters.delta = 1e-2;
  return scene;
}

Scene crossed_coarse_grid(const Meshes& meshes) {
  Scene scene =
      scene_over(meshes.at("grid_coarse"), "arap",
                 "Two vertices of one column change places in a held grid: with flips only.");
  const auto vertex = [](int i, int j) { return j * (kCoarseGrid.columns + 1) + i; };
  pin(scene, grid_square(kCoarseGrid, 0, kCoarseGrid.columns, true));
  exchange(scene, vertex(3, 1), vertex(3, 4));
  scene.parameters.delta = 1e-3;
  return scene;
}

Scene split_coarse_grid(const Meshes& meshes) {
  Scene scene =
      scene_over(meshes.at("grid_coarse"), "lscm",
                 "Two pairs change places: flips alone end short of it, and splits go on.");
  const auto vertex = [](int i, int j) { return j * (kCoarseGrid.columns + 1) + i; };
  pin(scene, grid_square(kCoarseGrid, 0, kCoarseGrid.columns, true));
  exchange(scene, vertex(1, 3), vertex(2, 4));
  exchange(scene, vertex(3, 1), vertex(4, 3));
  scene.parameters.delta = 1e-3;
  scene.parameters.method = "paper";
  return scene;
}

/// Both outlines are divided by length; the vertex of the disk that is `start` boundary vertices
/// from its rightmost one goes between the legs.
Scene disk_to_cowboy(const Meshes& meshes, std::size_t start) {
  Scene scene = scene_over(meshes.at("disk_dense"), "lscm",
                           "The boundary of a disk goes to the cowboy's outline, point by point.");
  const std::vector<int> boundary = disk_ring(kDenseDisk, kDenseDisk.rings);
  const std::size_t count = boundary.size();
  const Loop outline = sampled(cowboy(), static_cast<int>(count)).boundary;
  for (std::size_t i = 0; i < count; ++i)
    add_handle(scene, boundary[(i + start) % count], outline[i] - Vec2(0, 1.4));
  return scene;
}

/// Each target a quarter of the outline farther than where the disk would lie upright.
Scene turned_disk_to_cowboy(const Meshes& meshes) {
  Scene scene = disk_to_cowboy(meshes, 60);
  scene.description =
      "The boundary goes to the cowboy's outline and a quarter round it: crossing paths block the "
      "paper's methods.";
  scene.parameters.method = "foldless";
  return scene;
}

Scene swirl(const Meshes& meshes) {
  Scene scene = scene_over(meshes.at("grid_dense"), "arap",
                           "The middle turns by 180 degrees: flipped edges (key 6) wind round it.");
  pin(scene, grid_square(kDenseGrid, 0, kDenseGrid.columns, true));
  turn(scene, grid_square(kDenseGrid, 3, 7, false), {0.5, 0.5}, 180);
  return scene;
}

}  // namespace

std::vector<SampleScene> sample_scenes(const std::vector<SampleMesh>& all) {
  const Meshes meshes(all);
  return {
      {"welcome", welcome(meshes)},
      {"figure1_blocked_edge", blocked_edge(meshes)},
      {"figure2_relaxation", relaxed_disk(meshes)},
      {"figure3_flipped_edges", flipped_bar(meshes)},
      {"figure5_coarse_disk", coarse_disk(meshes)},
      {"figure6_dense_disk", dense_disk(meshes)},
      {"figure7_smooth_sequence", smooth_sequence(meshes)},
      {"figure8_eta_10_percent", dense_disk_with_eta(meshes, 0.1)},
      {"figure8_eta_1_percent", dense_disk_with_eta(meshes, 0.01)},
      {"figure8_eta_0.1_percent", dense_disk_with_eta(meshes, 0.001)},
      {"figure9_delta_1e-5", coarse_disk_with_delta(meshes, 1e-5)},
      {"figure9_delta_1e-3", coarse_disk_with_delta(meshes, 1e-3)},
      {"figure9_delta_1e-1", coarse_disk_with_delta(meshes, 1e-1)},
      {"figure10_alligator", alligator_bends(meshes)},
      {"figure10_cowboy", cowboy_waves(meshes)},
      {"figure11_coarse_grid", crossed_coarse_grid(meshes)},
      {"figure11_dense_grid", turned_dense_grid(meshes)},
      {"figure12_splits", split_coarse_grid(meshes)},
      {"figure14_disk_to_cowboy", disk_to_cowboy(meshes, 90)},
      {"figure14_turned_disk_to_cowboy", turned_disk_to_cowboy(meshes)},
      {"swirl_180", swirl(meshes)},
      {"walk", walk(meshes.at("gingerbread"))},
      {"snap", snap(meshes.at("alligator"))},
      {"turn_360", turn_by_360(meshes.at("disk_coarse"))},
  };
}

}  // namespace foldless::samples
