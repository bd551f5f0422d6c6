// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/depth/paint_group.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include "core/mesh/components.h"

namespace foldless {
namespace {

/// What lies between is the depth of some triangle of a part.
struct DepthRange {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;

  void include(const DepthRange& other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
};

/// Of every component, by its number: a harmonic function lies between its values at the handles,
/// and is 0 where there is none.
std::map<int, DepthRange> ranges_of_components(const std::vector<int>& component,
                                               std::span<const HandleDepth> handles) {
  std::map<int, DepthRange> ranges;
  for (const auto& [vertex, depth] : handles)
    ranges[component[static_cast<std::size_t>(vertex)]].include({depth, depth});
  return ranges;
}

/// The parts of a mesh, and of every triangle which it belongs to.
struct PartsOfTriangles {
  std::span<const MeshPart> parts;
  const std::vector<int>& of_triangle;
};

std::vector<DepthRange> ranges_of_parts(const Triangles& triangles, int vertex_count,
                                        const PartsOfTriangles& mesh,
                                        std::span<const HandleDepth> handles) {
  const auto& [parts, part_of_triangle] = mesh;
  const std::vector<int> component = components_of(triangles, vertex_count);
  const auto of_component = ranges_of_components(component, handles);
  std::vector<DepthRange> ranges(parts.size());
  for (std::size_t t = 0; t < part_of_triangle.size(); ++t) {
    const int vertex = triangles(0, static_cast<Eigen::Index>(t));
    const auto found = of_component.find(component[static_cast<std::size_t>(vertex)]);
    DepthRange range = found == of_component.end() ? DepthRange{0, 0} : found->second;
    const auto part = static_cast<std::size_t>(part_of_triangle[t]);
    range.low += parts[part].depth;
    range.high += parts[part].depth;
    ranges[part].include(range);
  }
  return ranges;
}

/// For every part its group, the groups from back to front.
std::vector<std::size_t> groups_of_parts(const std::vector<DepthRange>& ranges) {
  std::vector<std::size_t> by_depth(ranges.size());
  std::iota(by_depth.begin(), by_depth.end(), std::size_t{0});
  std::ranges::stable_sort(by_depth, {}, [&](std::size_t part) { return ranges[part].low; });
  std::vector<std::size_t> groups(ranges.size());
  std::size_t group = 0;
  DepthRange range = ranges[by_depth.front()];
  for (const std::size_t part : by_depth) {
    if (ranges[part].low > range.high) {
      ++group;
      range = ranges[part];
    }
    range.include(ranges[part]);
    groups[part] = group;
  }
  return groups;
}

}  // namespace

PaintGroup::PaintGroup(std::shared_ptr<const Triangles> triangles, std::vector<int> of_mesh,
                       int vertex_count)
    : triangles_(std::move(triangles)),
      of_mesh_(std::move(of_mesh)),
      vertex_count_(vertex_count),
      boundary_(*triangles_, vertex_count) {}

void PaintGroup::find_overlaps(const Points& points) {
  const bool have_open_corners = boundary_.have_open_corners(points);
  overlaps_.clear();
  if (have_open_corners && !boundary_.meet(points) && !boundary_.are_nested(points)) return;
  if (!search_) search_.emplace(*triangles_, vertex_count_);
  overlaps_ =
      search_->find(points, have_open_corners ? CommonCorners::apart : CommonCorners::may_overlap);
}

int PaintGroup::paint(const PaintKeys& keys_of_mesh, int first, std::vector<int>& layers) const {
  const PaintKeys keys{keys_of_mesh.depth(of_mesh_), keys_of_mesh.order(of_mesh_)};
  const std::vector<int> own = paint_layers(*triangles_, overlaps_, keys);
  int most = 0;
  for (std::size_t t = 0; t < own.size(); ++t) {
    layers[static_cast<std::size_t>(of_mesh_[t])] = first + own[t];
    most = std::max(most, own[t]);
  }
  return first + most + 1;
}

int PaintGroup::paint_flat(int first, std::vector<int>& layers) const {
  for (const int t : of_mesh_) layers[static_cast<std::size_t>(t)] = first;
  return first + 1;
}

std::vector<PaintGroup> paint_groups(const std::shared_ptr<const Triangles>& triangles,
                                     int vertex_count, std::span<const MeshPart> parts,
                                     std::span<const HandleDepth> handles) {
  std::vector<PaintGroup> groups;
  if (parts.empty()) {
    std::vector<int> all(static_cast<std::size_t>(triangles->cols()));
    std::iota(all.begin(), all.end(), 0);
    groups.emplace_back(triangles, std::move(all), vertex_count);
    return groups;
  }
  const std::vector<int> part = parts_of_triangles(*triangles, vertex_count, parts);
  const std::vector<std::size_t> group_of =
      groups_of_parts(ranges_of_parts(*triangles, vertex_count, {parts, part}, handles));
  std::vector<std::vector<int>> members(parts.size());
  for (std::size_t t = 0; t < part.size(); ++t)
    members[group_of[static_cast<std::size_t>(part[t])]].push_back(static_cast<int>(t));
  for (std::vector<int>& of_mesh : members) {
    if (of_mesh.empty()) continue;
    auto own = std::make_shared<const Triangles>((*triangles)(Eigen::all, of_mesh));
    groups.emplace_back(std::move(own), std::move(of_mesh), vertex_count);
  }
  return groups;
}

}  // namespace foldless
