// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/cut_disk.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/construct/chord_triangulation.h"
#include "core/construct/corner_order.h"
#include "core/construct/directed_edge.h"
#include "core/construct/in_circle.h"
#include "core/mesh/orientation.h"

namespace foldless {
namespace {

constexpr double kForbidden = std::numeric_limits<double>::infinity();
/// Rounding must not flip an edge for ever.
constexpr int kMostRoundsOfFlips = 1000;

std::size_t ordinal(int index) { return static_cast<std::size_t>(index); }

}  // namespace

std::optional<CutDisk> CutDisk::over(const Points& polygon, const Points& inside) {
  const CornerOrder order(polygon);
  const auto chords = triangulate_by_chords(order.corners(), [&](int i, int j, int k) {
    return order.is_piece(i, j, k) ? (polygon.col(i) - polygon.col(k)).norm() : kForbidden;
  });
  if (!chords) return std::nullopt;
  CutDisk disk;
  for (const Vec2 p : polygon.colwise()) disk.outline_.push_back(disk.add_vertex(p));
  disk.is_on_outline_.assign(disk.outline_.size(), true);
  disk.diagonal_ = (polygon.rowwise().maxCoeff() - polygon.rowwise().minCoeff()).norm();
  for (const auto& t : chords->colwise()) disk.set_triangle(disk.face_count(), t);
  disk.make_delaunay();
  for (const Vec2 p : inside.colwise())
    if (!disk.insert(disk.add_vertex(p))) return std::nullopt;
  disk.make_delaunay();
  return disk;
}

bool CutDisk::is_beside(int v, int first, int other) const {
  return std::ranges::any_of(triangles_, [&](const Eigen::Vector3i& t) {
    return (t.array() == v).any() &&
           std::ranges::any_of(t, [&](int w) { return w >= first || w == other; });
  });
}

std::vector<int> CutDisk::cut(const Way& way, int v, int least_between) {
  std::vector<int> vertices{way.corner};
  for (const auto& [a, b] : way.crossed) vertices.push_back(split(a, b, 0.5));
  vertices.push_back(v);
  divide(vertices, least_between);
  open(vertices);
  return vertices;
}

// Where they make the longest pieces shortest.
void CutDisk::divide(std::vector<int>& way, int least_between) {
  std::vector<int> parts(way.size() - 1, 1);
  const auto length = [&](std::size_t i) {
    return (position(way[i + 1]) - position(way[i])).norm() / parts[i];
  };
  for (std::size_t between = way.size() - 2; between < ordinal(least_between); ++between) {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < parts.size(); ++i)
      if (length(i) > length(longest)) longest = i;
    ++parts[longest];
  }
  std::vector<int> divided{way.front()};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (int part = parts[i]; part > 1; --part)
      divided.push_back(split(divided.back(), way[i + 1], 1.0 / part));
    divided.push_back(way[i + 1]);
  }
  way = std::move(divided);
}

void CutDisk::open(const std::vector<int>& way) {
  std::vector<std::vector<int>> on_the_left;  // triangles at each vertex of the way but the last
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    std::vector<int>& fan = on_the_left.emplace_back();
    const int v = way[i];
    for (int w = way[i + 1]; i == 0 || w != way[i - 1];) {
      const int t = left_of(v, w);
      if (t < 0) break;
      fan.push_back(t);
      w = opposite(t, v, w);
    }
  }
  std::vector<int> bank;
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    const int copy = add_vertex(position(way[i]));
    origins_[ordinal(copy)] = origin(way[i]);
    bank.push_back(copy);
    for (const int t : on_the_left[i]) {
      Eigen::Vector3i corners = triangles_[ordinal(t)];
      for (int& corner : corners)
        if (corner == way[i]) corner = copy;
      set_triangle(t, corners);
    }
  }
  const auto place = std::ranges::find(outline_, way.front());
  bank.insert(bank.end(), way.rbegin(), way.rend() - 1);
  outline_.insert(place, bank.begin(), bank.end());
  is_on_outline_.resize(positions_.size(), false);
  for (const int v : bank) is_on_outline_[ordinal(v)] = true;
}

int CutDisk::left_of(int a, int b) const {
  const auto found = left_.find(directed_edge(a, b));
  return found == left_.end() ? -1 : found->second;
}

int CutDisk::opposite(int t, int a, int b) const {
  const Eigen::Vector3i& corners = triangles_[ordinal(t)];
  return corners.sum() - a - b;
}

void CutDisk::set_triangle(int t, const Eigen::Vector3i& corners) {
  if (t == face_count()) {
    triangles_.push_back(corners);
  } else {
    Eigen::Vector3i& old = triangles_[ordinal(t)];
    for (int i = 0; i < 3; ++i) {
      const auto edge = left_.find(directed_edge(old[i], old[(i + 1) % 3]));
      if (edge != left_.end() && edge->second == t) left_.erase(edge);
    }
    old = corners;
  }
  for (int i = 0; i < 3; ++i) left_[directed_edge(corners[i], corners[(i + 1) % 3])] = t;
}

int CutDisk::add_vertex(const Vec2& position) {
  positions_.push_back(position);
  origins_.push_back(static_cast<int>(origins_.size()));
  is_on_outline_.push_back(false);
  return static_cast<int>(positions_.size()) - 1;
}

int CutDisk::split(int a, int b, double t) {
  const int m = add_vertex(position(a) + t * (position(b) - position(a)));
  put_on_edge(m, a, b);
  return m;
}

void CutDisk::put_on_edge(int v, int a, int b) {
  const int left = left_of(a, b), right = left_of(b, a);
  const int x = opposite(left, a, b), y = opposite(right, b, a);
  set_triangle(left, {a, v, x});
  set_triangle(face_count(), {v, b, x});
  set_triangle(right, {b, v, y});
  set_triangle(face_count(), {v, a, y});
}

bool CutDisk::insert(int v) {
  const std::vector<int> holding = triangles_at(position(v));
  if (holding.empty() || holding.size() > 2) return false;
  const Eigen::Vector3i c = triangles_[ordinal(holding.front())];
  for (int i = 0; i < 3; ++i) {
    const int a = c[i], b = c[(i + 1) % 3];
    if (orientation(position(a), position(b), position(v)) != 0) continue;
    if (holding.size() < 2 || left_of(b, a) != holding.back()) return false;
    put_on_edge(v, a, b);
    return true;
  }
  if (holding.size() == 2) return false;
  set_triangle(holding.front(), {c[0], c[1], v});
  set_triangle(face_count(), {c[1], c[2], v});
  set_triangle(face_count(), {c[2], c[0], v});
  return true;
}

std::vector<int> CutDisk::triangles_at(const Vec2& p) const {
  std::vector<int> holding;
  for (int t = 0; t < face_count(); ++t) {
    const Eigen::Vector3i& c = triangles_[ordinal(t)];
    bool is_in = true;
    for (int i = 0; i < 3 && is_in; ++i)
      is_in = orientation(position(c[i]), position(c[(i + 1) % 3]), p) >= 0;
    if (is_in) holding.push_back(t);
  }
  return holding;
}

void CutDisk::make_delaunay() {
  bool has_flipped = true;
  for (int round = 0; has_flipped && round < kMostRoundsOfFlips; ++round) {
    has_flipped = false;
    for (int t = 0; t < face_count(); ++t)
      for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3i c = triangles_[ordinal(t)];
        if (flip_if_better(c[i], c[(i + 1) % 3])) has_flipped = true;
      }
  }
}

bool CutDisk::flip_if_better(int a, int b) {
  const int left = left_of(a, b), right = left_of(b, a);
  if (right < 0) return false;
  const int x = opposite(left, a, b), y = opposite(right, b, a);
  if (left_of(x, y) >= 0 || left_of(y, x) >= 0) return false;
  const Vec2 pa = position(a), pb = position(b), px = position(x), py = position(y);
  if (!is_in_circle(pa, pb, px, py) || orientation(pa, py, px) <= 0 || orientation(py, pb, px) <= 0)
    return false;
  set_triangle(left, {a, y, x});
  set_triangle(right, {y, b, x});
  return true;
}

}  // namespace foldless
