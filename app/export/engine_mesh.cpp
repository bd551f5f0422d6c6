// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/engine_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "core/mesh/boundary.h"

namespace foldless {
namespace {

/// Bits of a coordinate; one fewer than single precision has, so that differences fit.
constexpr int kBits = 23;

/// Pixels of a square of what is repeated.
constexpr int kSquare = 32;

double largest_coordinate(const BakedAnimation& animation) {
  double largest = 0;
  for (const BakedFrame& frame : animation.frames)
    largest = std::max(largest, frame.deformed.cwiseAbs().maxCoeff());
  return largest;
}

/// The boundary loops, each from its least vertex on, the longest first.
std::vector<std::vector<int>> loops_of(const Triangles& triangles, const Points& points) {
  const std::vector<BoundaryNeighbours> neighbours =
      boundary_neighbours(triangles, static_cast<int>(points.cols()));
  std::vector<bool> is_seen(neighbours.size(), false);
  std::vector<std::pair<double, std::vector<int>>> loops;
  for (std::size_t v = 0; v < neighbours.size(); ++v) {
    if (is_seen[v] || !neighbours[v].are_there()) continue;
    auto& [length, loop] = loops.emplace_back(0, boundary_loop(neighbours, static_cast<int>(v)));
    for (std::size_t i = 0; i < loop.size(); ++i) {
      is_seen[static_cast<std::size_t>(loop[i])] = true;
      length += (points.col(loop[i]) - points.col(loop[(i + 1) % loop.size()])).norm();
    }
  }
  std::ranges::stable_sort(loops, std::greater(), [](const auto& loop) { return loop.first; });
  std::vector<std::vector<int>> result;
  for (auto& loop : loops) result.push_back(std::move(loop.second));
  return result;
}

}  // namespace

BakedAnimation in_pixels(const BakedAnimation& animation, const EngineUnits& units) {
  BakedAnimation result = animation;
  const auto convert = [&](Points& points) {
    points = (points.colwise() - units.origin) / units.pixel;
  };
  convert(result.rest);
  for (BakedFrame& frame : result.frames) convert(frame.deformed);
  result.deviation /= units.pixel;
  int exponent = 0;  // The largest coordinate is less than 2 to this.
  std::frexp(largest_coordinate(result), &exponent);
  const double step = std::ldexp(1.0, exponent - kBits);
  for (BakedFrame& frame : result.frames)
    frame.deformed = step * (frame.deformed / step).array().round().matrix();
  return result;
}

EngineMesh engine_mesh(const BakedAnimation& animation, const std::vector<int>& triangles) {
  Triangles of_piece(3, static_cast<Eigen::Index>(triangles.size()));
  std::set<int> used;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    of_piece.col(static_cast<Eigen::Index>(i)) = animation.triangles.col(triangles[i]);
    for (const int v : animation.triangles.col(triangles[i])) used.insert(v);
  }
  EngineMesh mesh;
  mesh.vertices = loops_of(of_piece, animation.rest).front();
  mesh.hull = static_cast<int>(mesh.vertices.size());
  for (const int v : mesh.vertices) used.erase(v);
  mesh.vertices.insert(mesh.vertices.end(), used.begin(), used.end());
  std::map<int, int> place;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    place[mesh.vertices[i]] = static_cast<int>(i);
  mesh.triangles = of_piece.unaryExpr([&](int v) { return place.at(v); });
  std::set<Edge> edges;
  for (const auto& t : mesh.triangles.colwise())
    for (int k = 0; k < 3; ++k)
      edges.insert({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])});
  mesh.edges.assign(edges.begin(), edges.end());
  return mesh;
}

GltfPiece without_tiles(const BakedAnimation& animation, const GltfPiece& piece) {
  if (!piece.is_tiled) return piece;
  const Vec2 most = animation.rest.rowwise().maxCoeff();
  const double square = (piece.place.max.x - piece.place.min.x) / piece.image.width;
  const auto squares = [&](double length) {
    return std::max(1, static_cast<int>(std::ceil(length / square - 1e-9)));
  };
  const int columns = squares(most.x() - piece.place.min.x);
  const int rows = squares(most.y() - piece.place.min.y);
  GltfPiece whole = piece;
  whole.is_tiled = false;
  whole.place.max = {piece.place.min.x + square * columns, piece.place.min.y + square * rows};
  check_image_size(columns * kSquare, rows * kSquare);
  whole.image = Image(columns * kSquare, rows * kSquare);
  const int tile = piece.image.height;
  for (int y = 0; y < whole.image.height; ++y)
    for (int x = 0; x < whole.image.width; ++x) {
      const int from_below = (whole.image.height - 1 - y) / kSquare;
      const std::uint8_t* colour =
          piece.image.at(x / kSquare % piece.image.width, tile - 1 - from_below % tile);
      std::copy_n(colour, 4, whole.image.at(x, y));
    }
  return whole;
}

std::vector<double> key_times(const BakedAnimation& animation) {
  std::vector<double> times;
  const double start = animation.frames.front().frame;
  for (const BakedFrame& frame : animation.frames)
    times.push_back((frame.frame - start) / animation.fps);
  if (animation.loops) times.push_back((animation.cycle_frames - start) / animation.fps);
  return times;
}

const Points& frame_of_key(const BakedAnimation& animation, std::size_t key) {
  return animation.frames[key % animation.frames.size()].deformed;
}

std::string picture_name(const std::string& name, std::size_t piece, std::size_t pieces) {
  return name + (pieces > 1 ? "-" + std::to_string(piece + 1) : "") + ".png";
}

}  // namespace foldless
