// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remesh/blockage.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foldless {
namespace {

/// Two crossings of the ray count as one point within this part of the distance to them, and a
/// point counts as the end of an edge within this part of its length.
constexpr double kCoincident = 1e-9;
/// An edge of C_α is split at v_α, but not nearer than this to its ends.
constexpr double kLeastParameter = 0.2;

/// The side of a triangle round v that is opposite to v, counter-clockwise seen from v.
struct LinkEdge {
  int a, b;
  double reach;  ///< parameter of the ray where it meets the line through a and b; may be infinite
};

/// ∂N(v) in order round v.
std::vector<LinkEdge> link_of(const MeshPair& mesh, int v, const Vec2& direction) {
  std::vector<LinkEdge> link;
  const Points& u = mesh.deformed();
  for (const int t : mesh.triangles_of_vertex(v)) {
    const Eigen::Vector3i corners = mesh.triangles().col(t);
    const int at = corners[0] == v ? 0 : corners[1] == v ? 1 : 2;
    const int a = corners[(at + 1) % 3], b = corners[(at + 2) % 3];
    const Vec2 along = u.col(b) - u.col(a);
    // The area of (v, a, b) shrinks at this rate along the ray; v is on the left of a–b.
    const double approach = -cross(along, direction);
    const double twice_area = cross(along, u.col(v) - u.col(a));
    link.push_back(
        {a, b, approach > 0 ? twice_area / approach : std::numeric_limits<double>::infinity()});
  }
  return link;
}

/// Where a point on the line through a link edge lies: 0 at a, 1 at b.
double parameter_of(const Points& u, const LinkEdge& e, const Vec2& point) {
  const Vec2 along = u.col(e.b) - u.col(e.a);
  return along.dot(point - u.col(e.a)) / along.squaredNorm();
}

/// Distance in parameter from v_α to the segment itself.
double distance_outside(const Points& u, const LinkEdge& e, const Vec2& v_alpha) {
  const double s = parameter_of(u, e, v_alpha);
  return std::max({0.0, -s, s - 1}) * (u.col(e.b) - u.col(e.a)).norm();
}

/// Connected components of C_α: runs of neighbours in the link, which is cyclic round an interior
/// vertex. The component farthest from v_α comes first, and within it the farthest edge.
std::vector<LinkEdge> in_order_of_splitting(const Points& u, const std::vector<LinkEdge>& c_alpha,
                                            const Vec2& v_alpha) {
  std::vector<double> distance(c_alpha.size());
  std::vector<std::size_t> component(c_alpha.size());
  for (std::size_t i = 0; i < c_alpha.size(); ++i) {
    distance[i] = distance_outside(u, c_alpha[i], v_alpha);
    component[i] = i > 0 && c_alpha[i - 1].b == c_alpha[i].a ? component[i - 1] : i;
  }
  if (c_alpha.size() > 1 && c_alpha.back().b == c_alpha.front().a) {
    const std::size_t last = component.back();
    std::ranges::replace(component, last, component.front());
  }
  std::vector<double> nearest(c_alpha.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < c_alpha.size(); ++i)
    nearest[component[i]] = std::min(nearest[component[i]], distance[i]);
  std::vector<std::size_t> order(c_alpha.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::stable_sort(order, [&](std::size_t i, std::size_t j) {
    const double ni = nearest[component[i]], nj = nearest[component[j]];
    if (component[i] != component[j]) return ni != nj ? ni > nj : component[i] < component[j];
    return distance[i] > distance[j];
  });
  std::vector<LinkEdge> sorted;
  sorted.reserve(order.size());
  for (const std::size_t i : order) sorted.push_back(c_alpha[i]);
  return sorted;
}

void add(std::vector<EdgeSplit>& splits, const EdgeSplit& split) {
  if (std::ranges::find(splits, split.edge, &EdgeSplit::edge) == splits.end())
    splits.push_back(split);
}

/// The three cases of 4.4 for one edge of C_α(v).
void add_splits(const MeshPair& mesh, int v, const LinkEdge& e, Blockage& blockage) {
  const double s = parameter_of(mesh.deformed(), e, blockage.v_alpha);
  const bool is_at_end = std::abs(s) <= kCoincident || std::abs(s - 1) <= kCoincident;
  const bool is_inside = !is_at_end && 0 < s && s < 1;
  if (is_inside || is_at_end) {
    const int edge = mesh.find_edge(e.a, e.b).value();
    const double from_a = std::clamp(s, kLeastParameter, 1 - kLeastParameter);
    add(blockage.splits, {edge, mesh.edge(edge)[0] == e.a ? from_a : 1 - from_a});
  }
  if (!is_inside) add(blockage.splits, {mesh.find_edge(v, s < 0.5 ? e.b : e.a).value(), 0.5});
}

}  // namespace

std::optional<Blockage> blockage_of(const MeshPair& mesh, int v, const Vec2& direction) {
  const std::vector<LinkEdge> link = link_of(mesh, v, direction);
  double nearest = std::numeric_limits<double>::infinity();
  for (const LinkEdge& e : link) nearest = std::min(nearest, e.reach);
  if (!std::isfinite(nearest)) return std::nullopt;

  Blockage blockage;
  blockage.v_alpha = mesh.deformed().col(v) + nearest * direction;
  std::vector<LinkEdge> c_alpha;
  for (const LinkEdge& e : link)
    if (e.reach <= nearest * (1 + kCoincident)) c_alpha.push_back(e);
  for (const LinkEdge& e : c_alpha) blockage.blocking.push_back(mesh.find_edge(e.a, e.b).value());
  for (const LinkEdge& e : in_order_of_splitting(mesh.deformed(), c_alpha, blockage.v_alpha))
    add_splits(mesh, v, e, blockage);
  return blockage;
}

}  // namespace foldless
