// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outline/image_mesh.h"

#include <gtest/gtest.h>

#include <set>

#include "core/error.h"
#include "core/mesh/components.h"
#include "core/mesh/injective.h"
#include "tests/support/alpha_maps.h"
#include "tests/support/errors.h"
#include "tests/support/mesh_measures.h"

namespace foldless {
namespace {

using test::error_of;
using test::ring_map;

int component_count(const Shape& shape) {
  const auto marks = components_of(shape.triangles, static_cast<int>(shape.rest.cols()));
  return static_cast<int>(std::set<int>(marks.begin(), marks.end()).size());
}

/// What every mesh of a picture must be.
void expect_sound(const ImageMesh& mesh, const AlphaMap& map) {
  const Shape& shape = mesh.shape;
  EXPECT_TRUE(is_injective(shape.triangles, shape.rest));
  EXPECT_EQ(component_count(shape), mesh.parts);
  EXPECT_EQ(test::euler_characteristic(shape), mesh.parts - mesh.holes);
  EXPECT_DOUBLE_EQ(mesh.min_angle, test::min_angle(shape));
  EXPECT_GE(shape.rest.minCoeff(), 0);
  EXPECT_LE(shape.rest.row(0).maxCoeff(), map.width);
  EXPECT_LE(shape.rest.row(1).maxCoeff(), map.height);
}

TEST(ImageMesh, OfARingWithADiskHasTwoPartsAndAHole) {
  const AlphaMap map = ring_map(400);
  const ImageMeshOptions options = options_for(map);
  const ImageMesh mesh = *mesh_of_image(map, options);
  expect_sound(mesh, map);
  EXPECT_EQ(mesh.parts, 2);
  EXPECT_EQ(mesh.holes, 1);
  EXPECT_GE(mesh.min_angle, options.min_angle - 1e-9);
  EXPECT_LE(test::max_edge_length(mesh.shape), options.edge_length + 1e-9);
}

TEST(ImageMesh, DefaultsGiveAboutTwoThousandVerticesAtAnySize) {
  for (const int side : {200, 700, 2000}) {
    const AlphaMap map = ring_map(side);
    const auto vertices = mesh_of_image(map, options_for(map))->shape.rest.cols();
    EXPECT_GT(vertices, 1500) << side;
    EXPECT_LT(vertices, 2500) << side;
  }
}

TEST(ImageMesh, DetailIsCoarseMediumOrFine) {
  const AlphaMap map = ring_map(500);
  const auto vertices = [&](MeshDetail detail) {
    return mesh_of_image(map, options_for(map, detail))->shape.rest.cols();
  };
  EXPECT_NEAR(static_cast<double>(vertices(MeshDetail::coarse)), 500, 200);
  EXPECT_NEAR(static_cast<double>(vertices(MeshDetail::fine)), 8000, 2000);
}

TEST(ImageMesh, AnyPictureGivesASoundMesh) {
  const unsigned seed = 20261122;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit;
  for (int trial = 0; trial < 150; ++trial) {
    SCOPED_TRACE(testing::Message() << "trial " << trial);
    const int width = 1 + static_cast<int>(random() % 60);
    const AlphaMap map = test::random_map(random, width, 1 + static_cast<int>(random() % 60));
    const ImageMeshOptions options{.threshold = 0.05 + 0.9 * unit(random),
                                   .margin = trial % 3 == 0 ? 0 : 0.01 + unit(random),
                                   .simplify = trial % 2 == 0 ? 0 : 2 * unit(random),
                                   .edge_length = 2 + 10 * unit(random)};
    try {
      expect_sound(*mesh_of_image(map, options), map);
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("transparent everywhere"), std::string::npos)
          << error.what();
    }
  }
}

TEST(ImageMesh, SmallestPicturesHaveAMesh) {
  for (const auto& [width, height] : {std::pair{1, 1}, {2, 1}, {1, 50}, {3, 3}}) {
    const AlphaMap map = test::opaque_map(width, height);
    const ImageMesh mesh = *mesh_of_image(map, options_for(map));
    expect_sound(mesh, map);
    EXPECT_NEAR(test::area_of(mesh.shape), width * height, 1e-9);
  }
}

TEST(ImageMesh, TheSamePictureGivesTheSameMesh) {
  const AlphaMap map = ring_map(300);
  const ImageMesh a = *mesh_of_image(map, options_for(map));
  const ImageMesh b = *mesh_of_image(map, options_for(map));
  EXPECT_TRUE(a.shape.rest == b.shape.rest);
  EXPECT_TRUE(a.shape.triangles == b.shape.triangles);
}

TEST(ImageMesh, StopsWhenItIsAskedTo) {
  std::stop_source source;
  source.request_stop();
  const AlphaMap map = ring_map(300);
  EXPECT_FALSE(mesh_of_image(map, options_for(map), source.get_token()).has_value());
}

TEST(ImageMesh, RefusesTooManyVerticesAndOptionsOutOfRange) {
  const AlphaMap map = test::opaque_map(1000, 1000);
  EXPECT_NE(error_of([&] { mesh_of_image(map, {.edge_length = 1}); }).find("200000 vertices"),
            std::string::npos);
  EXPECT_NE(error_of([&] { mesh_of_image(map, {.edge_length = 0}); }), "");
  EXPECT_NE(error_of([&] { mesh_of_image(map, {.min_angle = 50}); }), "");
}

}  // namespace
}  // namespace foldless
