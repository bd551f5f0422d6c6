// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/drag_suite.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "app/bench/random_mesh.h"
#include "core/energy/densities.h"
#include "core/mesh/generate.h"
#include "core/method/satisfied.h"

namespace foldless {
namespace {

constexpr double kStride = 0.01;  ///< of a frame [D]

/// A part of the curve: a turn on the spot, then so many frames that bend all alike.
struct Leg {
  double turn;  ///< before the first frame, counter-clockwise [rad]
  int frames;
  double bend;  ///< a frame [rad]
};

constexpr double kBack = std::numbers::pi;

// Out, round a circle, back round it and to the start, then a tight bend there and back.
constexpr std::array kLegs{Leg{0, 20, 0},          Leg{0, 30, 0.15},  Leg{kBack, 30, -0.15},
                           Leg{-0.15, 20, 0},      Leg{0.5, 15, 0.3}, Leg{kBack, 15, -0.3},
                           Leg{0.5 * kBack, 10, 0}};

void hold(Scene& scene, int vertex, HandleKind kind) {
  const int id = static_cast<int>(scene.handles.size()) + 1;
  scene.handles.push_back({id, vertex, scene.rest.col(vertex), kind});
}

/// The last handle goes along the curve.
void add_drag(BenchScene& drag, double heading) {
  Scene& scene = drag.scene;
  const auto count = static_cast<Eigen::Index>(scene.handles.size());
  Points targets(2, count);
  for (Eigen::Index i = 0; i < count; ++i)
    targets.col(i) = scene.handles[static_cast<std::size_t>(i)].target;
  const double stride = kStride * bounding_box_diagonal(scene.rest);
  for (const Vec2& point : drag_curve(targets.col(count - 1), heading, stride)) {
    targets.col(count - 1) = point;
    drag.targets.push_back(targets);
  }
}

BenchScene scene_of(const std::string& name, const Shape& shape) {
  BenchScene drag;
  drag.name = name + "-" + std::to_string(shape.triangles.cols());
  drag.scene.triangles = shape.triangles;
  drag.scene.rest = shape.rest.unaryExpr(&suite_coordinate);
  drag.scene.energy = find_density("arap");
  drag.scene.description = drag.name;
  return drag;
}

/// The middle of a square whose corners are held.
BenchScene square(int cells) {
  BenchScene drag = scene_of(
      "square", grid({.columns = cells, .rows = cells, .diagonal = Diagonal::alternating}));
  const int row = cells + 1;
  for (const int v : {0, cells, cells * row, cells * row + cells})
    hold(drag.scene, v, HandleKind::pin);
  hold(drag.scene, cells / 2 * row + cells / 2, HandleKind::drag);
  add_drag(drag, 0.4);
  return drag;
}

/// The end of a bar whose other end is held.
BenchScene arm(int cells) {
  BenchScene drag = scene_of("bar", bar(4, 1, cells));
  const int row = 4 * cells + 1;
  hold(drag.scene, 0, HandleKind::pin);
  hold(drag.scene, cells * row, HandleKind::pin);
  hold(drag.scene, cells / 2 * row + row - 1, HandleKind::drag);
  add_drag(drag, 2);
  return drag;
}

}  // namespace

std::vector<Vec2> drag_curve(const Vec2& from, double heading, double stride) {
  std::vector<Vec2> points;
  Vec2 point = from;
  for (const Leg& leg : kLegs) {
    heading += leg.turn;
    for (int frame = 0; frame < leg.frames; ++frame) {
      point += stride * Vec2(std::cos(heading), std::sin(heading));
      points.push_back(point.unaryExpr(&suite_coordinate));
      heading += leg.bend;
    }
  }
  return points;
}

BenchScene drag_scene(int index) {
  constexpr std::array kCellsOfSquares{16, 50, 158, 500}, kCellsOfBars{8, 25, 79, 250};
  const auto size = static_cast<std::size_t>(index / 2);
  return index % 2 == 0 ? square(kCellsOfSquares[size]) : arm(kCellsOfBars[size]);
}

}  // namespace foldless
