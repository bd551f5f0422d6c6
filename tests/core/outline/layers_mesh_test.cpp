// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outline/layers_mesh.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/mesh/injective.h"
#include "tests/support/alpha_maps.h"
#include "tests/support/errors.h"

namespace foldless::test {
namespace {

ImageMeshOptions options() { return {0.1, 2, 1, 12, 20}; }

TEST(LayersMesh, HasAPartForEveryLayerInItsPlace) {
  const std::vector<LayerAlpha> layers{
      {"Body", 20, 30, ring_map(120)},
      {"Nothing", 0, 0, alpha_map(5, 5, [](double, double) { return 0.05; })},
      {"Arm", 100, 60, opaque_map(90, 30)}};
  const Vec2 canvas(200, 160);
  const auto result = mesh_of_layers(layers, canvas, options());
  ASSERT_TRUE(result.has_value());
  EXPECT_EQ(result->left_out, std::vector<std::string>{"Nothing"});
  ASSERT_EQ(result->parts.size(), 2U);
  const MeshPart &body = result->parts[0], &arm = result->parts[1];
  EXPECT_EQ(body.layer, "Body");
  EXPECT_EQ(arm.layer, "Arm");
  EXPECT_EQ(body.first_vertex, 0);
  EXPECT_EQ(arm.first_vertex, body.vertices);
  EXPECT_LT(body.depth, arm.depth);
  const Shape& shape = result->mesh.shape;
  EXPECT_EQ(arm.first_vertex + arm.vertices, shape.rest.cols());
  EXPECT_EQ(result->mesh.parts, 3) << "ring, disk and arm";
  EXPECT_EQ(result->mesh.holes, 1);
  EXPECT_TRUE(is_injective(shape.triangles, shape.rest));
  const Points of_arm = shape.rest.rightCols(arm.vertices);
  // The block with its margin, y up, within the canvas.
  EXPECT_NEAR(of_arm.row(0).minCoeff(), 98, 1.5);
  EXPECT_NEAR(of_arm.row(0).maxCoeff(), 192, 1.5);
  EXPECT_NEAR(of_arm.row(1).minCoeff(), 160 - 92, 1.5);
  EXPECT_NEAR(of_arm.row(1).maxCoeff(), 160 - 58, 1.5);
}

TEST(LayersMesh, StaysOnTheCanvas) {
  const std::vector<LayerAlpha> layers{{"All", 0, 0, opaque_map(80, 50)}};
  const auto result = mesh_of_layers(layers, Vec2(80, 50), options());
  EXPECT_GE(result->mesh.shape.rest.minCoeff(), 0);
  EXPECT_LE(result->mesh.shape.rest.row(0).maxCoeff(), 80);
  EXPECT_LE(result->mesh.shape.rest.row(1).maxCoeff(), 50);
}

TEST(LayersMesh, SaysWhatIsWrong) {
  const std::vector<LayerAlpha> clear{
      {"A", 0, 0, alpha_map(9, 9, [](double, double) { return 0.0; })}};
  EXPECT_NE(error_of([&] { mesh_of_layers(clear, Vec2(9, 9), options()); }).find("transparent"),
            std::string::npos);
  const std::vector<LayerAlpha> layer{{"Sky", 0, 0, opaque_map(900, 900)}};
  ImageMeshOptions fine = options();
  fine.edge_length = 0.5;
  EXPECT_TRUE(error_of([&] {
                mesh_of_layers(layer, Vec2(900, 900), fine);
              }).starts_with("the layer 'Sky': the mesh would have more than 200000"));
  fine.edge_length = 4;
  const std::vector<LayerAlpha> many(4, {"Sky", 0, 0, opaque_map(900, 900)});
  EXPECT_NE(error_of([&] {
              mesh_of_layers(many, Vec2(900, 900), fine);
            }).find("of the layers would have more than 200000"),
            std::string::npos);
}

TEST(LayersMesh, UnitedLayersAreAsOpaqueAsTheMostOpaque) {
  const std::vector<LayerAlpha> layers{
      {"A", 1, 0, alpha_map(2, 2, [](double, double) { return 0.4; })},
      {"B", 2, 1, opaque_map(2, 1)}};
  const AlphaMap all = united(layers, Vec2(5, 3));
  EXPECT_EQ(all.values, (std::vector<std::uint8_t>{0, 102, 102, 0, 0,    //
                                                   0, 102, 255, 255, 0,  //
                                                   0, 0, 0, 0, 0}));
}

TEST(LayersMesh, CanBeStopped) {
  std::stop_source stop;
  stop.request_stop();
  const std::vector<LayerAlpha> layers{{"A", 0, 0, opaque_map(80, 50)}};
  EXPECT_FALSE(mesh_of_layers(layers, Vec2(80, 50), options(), stop.get_token()).has_value());
}

}  // namespace
}  // namespace foldless::test
