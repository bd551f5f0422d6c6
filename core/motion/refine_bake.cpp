// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/refine_bake.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <span>
#include <utility>

#include "core/mesh/orientation.h"

namespace foldless {
namespace {

/// Of the longest edge of the drawing's triangle around it.
constexpr double kShortestHalved = 1.0 / 32;

/// Triangles of a lesser shape have their edges flipped rather than split: a vertex lies close to
/// the edge then, and another on the edge beside it would make thinner ones.
constexpr double kThin = 0.01;

}  // namespace

RefineBake::RefineBake(const Triangles& original, const Points& rest)
    : mesh_(original, rest), original_(original) {
  for (int t = 0; t < mesh_.face_count(); ++t) longest_of_origin_.push_back(longest_edge(t).second);
}

std::shared_ptr<const RestCover> RefineBake::cover_of(const Snapshot& snapshot) {
  std::shared_ptr<const RestCover>& cover = covers_[snapshot.triangles.get()];
  if (!cover || !cover->is_of(snapshot))
    cover = std::make_shared<const RestCover>(snapshot, original_);
  return cover;
}

std::size_t RefineBake::add_frame(std::shared_ptr<const Snapshot> snapshot) {
  const auto cover = cover_of(*snapshot);
  maps_.emplace_back(std::move(snapshot), cover);
  const FrameMap& map = maps_.back();
  std::vector<Vec2>& places = deformed_.emplace_back();
  const int original_vertices = map.snapshot().original_vertices;
  for (int v = 0; v < original_vertices; ++v) places.emplace_back(map.snapshot().deformed.col(v));
  places.resize(static_cast<std::size_t>(mesh_.vertex_count()), Vec2::Zero());
  for (int t = 0; t < mesh_.face_count(); ++t) {
    for (const int v : mesh_.triangle(t))
      if (v >= original_vertices)
        places[static_cast<std::size_t>(v)] = map.at(mesh_.rest(v), mesh_.origin(t));
    unsettled_.insert(unsettled_.end(), t);
  }
  return maps_.size() - 1;
}

bool RefineBake::is_counter_clockwise(int t, std::size_t frame) const {
  const std::vector<Vec2>& places = deformed_[frame];
  const auto at = [&](int corner) -> const Vec2& {
    return places[static_cast<std::size_t>(mesh_.triangle(t)[corner])];
  };
  return orientation(at(0), at(1), at(2)) > 0;
}

void RefineBake::add_crossings(int t, std::size_t frame, int other,
                               std::vector<Parting>& found) const {
  const Snapshot& snapshot = maps_[frame].snapshot();
  const Eigen::Vector3i of_frame = snapshot.triangles->col(other);
  const Eigen::Vector3i& of_mesh = mesh_.triangle(t);
  const std::vector<Vec2>& places = deformed_[frame];
  for (int i = 0; i < 3; ++i) {
    const int a = of_mesh[i], b = of_mesh[(i + 1) % 3];
    const Vec2 rest_a = mesh_.rest(a), rest_b = mesh_.rest(b);
    for (int k = 0; k < 3; ++k) {
      const int c = of_frame[k], d = of_frame[(k + 1) % 3];
      const Vec2 rest_c = snapshot.rest->col(c), rest_d = snapshot.rest->col(d);
      if (orientation(rest_a, rest_b, rest_c) * orientation(rest_a, rest_b, rest_d) >= 0 ||
          orientation(rest_c, rest_d, rest_a) * orientation(rest_c, rest_d, rest_b) >= 0)
        continue;
      const double of_a = signed_area(rest_c, rest_d, rest_a);
      const double of_b = signed_area(rest_c, rest_d, rest_b);
      const double of_c = signed_area(rest_a, rest_b, rest_c);
      const double of_d = signed_area(rest_a, rest_b, rest_d);
      const double s = of_a / (of_a - of_b), r = of_c / (of_c - of_d);
      if (!(s > 0 && s < 1 && r > 0 && r < 1)) continue;
      const Vec2 here =
          (1 - s) * places[static_cast<std::size_t>(a)] + s * places[static_cast<std::size_t>(b)];
      const Vec2 there = (1 - r) * snapshot.deformed.col(c) + r * snapshot.deformed.col(d);
      found.push_back({(here - there).norm(), (1 - s) * rest_a + s * rest_b, Edge{a, b}});
    }
  }
}

void RefineBake::add_vertices(int t, std::size_t frame, int other,
                              std::vector<Parting>& found) const {
  const Snapshot& snapshot = maps_[frame].snapshot();
  const Eigen::Vector3i& corners = mesh_.triangle(t);
  Eigen::Matrix<double, 2, 3> rest, deformed;
  for (int k = 0; k < 3; ++k) {
    rest.col(k) = mesh_.rest(corners[k]);
    deformed.col(k) = deformed_[frame][static_cast<std::size_t>(corners[k])];
  }
  for (const int v : snapshot.triangles->col(other)) {
    if (v < snapshot.original_vertices) continue;  // They are corners of the mesh.
    const Vec2 at = snapshot.rest->col(v);
    std::array<int, 3> sides{};
    for (int k = 0; k < 3; ++k)
      sides[static_cast<std::size_t>(k)] = orientation(rest.col(k), rest.col((k + 1) % 3), at);
    if (std::ranges::min(sides) < 0) continue;
    const auto on = std::ranges::count(sides, 0);
    if (on > 1) continue;  // A corner.
    const Vec2 here = deformed * barycentric(rest, at);
    Parting parting{(here - snapshot.deformed.col(v)).norm(), at};
    if (on == 1) {
      const auto k = static_cast<int>(std::ranges::find(sides, 0) - sides.begin());
      parting.edge = Edge{corners[k], corners[(k + 1) % 3]};
    }
    found.push_back(parting);
  }
}

std::vector<RefineBake::Parting> RefineBake::partings(int t, std::size_t frame) const {
  const std::span<const int> covering = maps_[frame].covering(mesh_.origin(t));
  std::vector<Parting> found;
  if (covering.size() == 1) return found;
  for (const int other : covering) {
    add_crossings(t, frame, other, found);
    add_vertices(t, frame, other, found);
  }
  return found;
}

/// The points to be added to a triangle, the one that parts most first; nothing for one that is as
/// it should be.
std::optional<std::vector<RefineBake::Parting>> RefineBake::what_to_mend(int t,
                                                                         double tolerance) const {
  std::vector<Parting> found;
  for (std::size_t frame = 0; frame < maps_.size(); ++frame) {
    const bool is_turned_over = !is_counter_clockwise(t, frame);
    for (const Parting& parting : partings(t, frame))
      if (is_turned_over || parting.distance > tolerance) found.push_back(parting);
  }
  if (found.empty()) return std::nullopt;
  std::ranges::stable_sort(found, std::greater(), &Parting::distance);
  return found;
}

void RefineBake::place_last_vertex(int origin) {
  const Vec2 rest = mesh_.rest(mesh_.vertex_count() - 1);
  for (std::size_t frame = 0; frame < maps_.size(); ++frame)
    deformed_[frame].push_back(maps_[frame].at(rest, origin));
}

void RefineBake::mark(const std::vector<int>& made, std::vector<bool>& changed) {
  changed.resize(static_cast<std::size_t>(mesh_.face_count()), false);
  for (const int t : made) {
    changed[static_cast<std::size_t>(t)] = true;
    unsettled_.insert(t);
  }
}

/// Adds the first of the points that can be added, or, where all of them would make needles, flips
/// an edge or halves the longest. Marks the triangles that it changed.
void RefineBake::mend(int t, const std::vector<Parting>& partings, std::vector<bool>& changed) {
  const int origin = mesh_.origin(t);
  const auto add = [&](const Parting& parting) {
    const auto& edge = parting.edge;
    const std::vector<int> made = edge ? mesh_.split_edge((*edge)[0], (*edge)[1], parting.at)
                                       : mesh_.split_triangle(t, parting.at);
    if (made.empty()) return false;
    place_last_vertex(origin);
    mark(made, changed);
    return true;
  };
  const auto flip = [&](const Parting& parting) {
    if (!parting.edge) return false;
    const std::vector<int> made = mesh_.flip_edge((*parting.edge)[0], (*parting.edge)[1]);
    mark(made, changed);
    return !made.empty();
  };
  if (mesh_.shape(mesh_.triangle(t)) < kThin && std::ranges::any_of(partings, flip)) return;
  if (std::ranges::any_of(partings, add) || std::ranges::any_of(partings, flip)) return;
  const auto [edge, length] = longest_edge(t);
  if (length < kShortestHalved * longest_of_origin_[static_cast<std::size_t>(origin)]) return;
  add({0, 0.5 * (mesh_.rest(edge[0]) + mesh_.rest(edge[1])), edge});
}

std::pair<Edge, double> RefineBake::longest_edge(int t) const {
  const Eigen::Vector3i& corners = mesh_.triangle(t);
  std::pair<Edge, double> longest{};
  for (int k = 0; k < 3; ++k) {
    const Edge edge{corners[k], corners[(k + 1) % 3]};
    const double length = (mesh_.rest(edge[1]) - mesh_.rest(edge[0])).norm();
    if (length > longest.second) longest = {edge, length};
  }
  return longest;
}

bool RefineBake::refine(double tolerance, int most_vertices,
                        const std::function<void(double)>& progress, const std::stop_token& token) {
  struct Task {
    int triangle;
    std::vector<Parting> partings;
  };
  while (!unsettled_.empty()) {
    std::vector<Task> tasks;
    auto left = unsettled_.size();
    for (const int t : std::exchange(unsettled_, {})) {
      if (token.stop_requested()) return false;
      if (auto found = what_to_mend(t, tolerance)) tasks.push_back({t, std::move(*found)});
      const auto unsettled = static_cast<double>(--left + tasks.size());
      progress(1 - unsettled / mesh_.face_count());
    }
    std::ranges::stable_sort(tasks, [](const Task& a, const Task& b) {
      return a.partings.front().distance > b.partings.front().distance;
    });
    // A triangle that a neighbour's point has changed already is looked at anew in the next round.
    std::vector<bool> changed(static_cast<std::size_t>(mesh_.face_count()), false);
    for (const Task& task : tasks) {
      if (mesh_.vertex_count() >= most_vertices) return true;
      if (!changed[static_cast<std::size_t>(task.triangle)])
        mend(task.triangle, task.partings, changed);
    }
  }
  return true;
}

Points RefineBake::deformed(std::size_t frame) const {
  const std::vector<Vec2>& places = deformed_[frame];
  Points result(2, static_cast<Eigen::Index>(places.size()));
  for (std::size_t v = 0; v < places.size(); ++v)
    result.col(static_cast<Eigen::Index>(v)) = places[v];
  return result;
}

Points RefineBake::take_deformed(std::size_t frame) {
  Points result = deformed(frame);
  std::exchange(deformed_[frame], {});
  return result;
}

double RefineBake::deviation() const {
  double largest = 0;
  for (std::size_t frame = 0; frame < maps_.size(); ++frame)
    for (int t = 0; t < mesh_.face_count(); ++t)
      for (const Parting& parting : partings(t, frame))
        largest = std::max(largest, parting.distance);
  return largest;
}

}  // namespace foldless
