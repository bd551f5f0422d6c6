// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/coarse_problem.h"

#include <algorithm>
#include <utility>

#include "core/mesh/injective.h"
#include "core/method/satisfied.h"
#include "core/multires/coarsen.h"

namespace foldless {
namespace coarse {

/// The coarse mesh has at most this part of the vertices.
constexpr double kLargestPart = 0.5;

double longest_way(const Problem& problem) {
  double longest = 0;
  for (const Handle& handle : problem.handles)
    longest =
        std::max(longest, (handle.target - problem.mesh.deformed().col(handle.vertex)).norm());
  return longest;
}

std::vector<int> handle_vertices(const Problem& problem) {
  std::vector<int> vertices;
  for (const Handle& handle : problem.handles) vertices.push_back(handle.vertex);
  return vertices;
}

}  // namespace coarse

std::optional<CoarseProblem> coarse_problem(const Problem& problem, const CoarseSettings& settings,
                                            const std::stop_token& token) {
  using namespace coarse;
  const int count = problem.mesh.vertex_count();
  const double short_way = settings.short_way * bounding_box_diagonal(problem.mesh.rest());
  if (count < settings.dense_from || longest_way(problem) < short_way) return std::nullopt;
  CoarseMesh coarse = coarsened(problem.mesh, handle_vertices(problem),
                                std::max(settings.least_vertices, count / settings.ratio), token);
  if (token.stop_requested() || coarse.mesh.vertex_count() > kLargestPart * count ||
      !is_injective(coarse.mesh.triangles(), coarse.mesh.deformed()))
    return std::nullopt;
  Problem small{std::move(coarse.mesh), problem.energy, problem.handles, problem.parameters};
  small.offset = problem.offset;
  for (Handle& handle : small.handles)
    handle.vertex = static_cast<int>(std::ranges::lower_bound(coarse.vertices, handle.vertex) -
                                     coarse.vertices.begin());
  return CoarseProblem{std::move(small), std::move(coarse.vertices)};
}

}  // namespace foldless
