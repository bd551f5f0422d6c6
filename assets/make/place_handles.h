// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "assets/make/sample_meshes.h"
#include "core/scene/scene.h"

namespace foldless::samples {

/// What all samples share: a mesh file, an energy, a line on what to look at.
Scene scene_over(const SampleMesh& mesh, const char* energy, std::string description);

void add_handle(Scene& scene, int vertex, const Vec2& target, HandleKind kind = HandleKind::drag);
/// Held where they are at rest.
void pin(Scene& scene, const std::vector<int>& vertices);
/// The vertices nearest to these places.
void pin_at(Scene& scene, const std::vector<Vec2>& places);
/// The vertex nearest to `from` goes to `to`.
void drag(Scene& scene, const Vec2& from, const Vec2& to);
void turn(Scene& scene, const std::vector<int>& vertices, const Vec2& centre, double degrees);
/// Two vertices, each with the rest position of the other as its target.
void exchange(Scene& scene, int a, int b);

Vec2 turned(const Vec2& p, const Vec2& centre, double degrees);
int nearest_vertex(const Scene& scene, const Vec2& p);
std::vector<int> vertices_near(const Scene& scene, const Vec2& centre, double radius);
/// The vertices of grid columns and rows [first, last], those of the border alone or all.
std::vector<int> grid_square(const GridOptions& grid, int first, int last, bool border_only);

}  // namespace foldless::samples
