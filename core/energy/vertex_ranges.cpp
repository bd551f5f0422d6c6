// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/vertex_ranges.h"

#include <algorithm>

#include "core/threads/values_of_ranges.h"

namespace foldless {
namespace {

/// Columns of the Hessian that stay in a core's cache, of not too many triangles between ranges.
constexpr int kFewestOfARange = 256, kMostOfARange = 8192;
/// Triangles of all ranges in a run, and those that have a place in several.
constexpr std::ptrdiff_t kShortestRun = 16;
constexpr double kMostTaken = 1.5;

using Runs = std::vector<TriangleRun>;

/// Puts a run at the end, of which the triangles that are there already are the first.
void append(Runs& runs, TriangleRun run) {
  if (runs.empty() || runs.back().end < run.begin)
    runs.push_back(run);
  else
    runs.back().end = std::max(runs.back().end, run.end);
}

/// By ranges of so many vertices, the runs of some triangles.
std::vector<Runs> runs_of(const Triangles& triangles, TriangleRun some, int count, int size) {
  std::vector<Runs> runs(static_cast<std::size_t>(count));
  for (int t = some.begin; t < some.end; ++t)
    for (const int v : triangles.col(t))
      append(runs[static_cast<std::size_t>(v / size)], {t, t + 1});
  return runs;
}

bool are_compact(const std::vector<VertexRange>& ranges, std::ptrdiff_t triangles) {
  std::ptrdiff_t runs = 0, taken = 0;
  for (const VertexRange& range : ranges) {
    runs += std::ssize(range.runs);
    for (const auto& [begin, end] : range.runs) taken += end - begin;
  }
  return kShortestRun * runs <= triangles &&
         static_cast<double>(taken) <= kMostTaken * static_cast<double>(triangles);
}

}  // namespace

std::vector<VertexRange> compact_ranges(const Triangles& triangles, std::size_t vertices,
                                        int count) {
  const int all = static_cast<int>(vertices);
  const int size = std::clamp((all + count - 1) / count, kFewestOfARange, kMostOfARange);
  std::vector<VertexRange> ranges;
  for (int begin = 0; begin < all; begin += size)
    ranges.push_back({begin, std::min(begin + size, all), {}});
  constexpr std::ptrdiff_t kTrianglesOfAPart = 8192;
  const auto parts = values_of_ranges(
      triangles.cols(), kTrianglesOfAPart, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
        return runs_of(triangles, {static_cast<int>(begin), static_cast<int>(end)},
                       static_cast<int>(ranges.size()), size);
      });
  for (const std::vector<Runs>& part : parts)
    for (std::size_t i = 0; i < ranges.size(); ++i)
      for (const TriangleRun& run : part[i]) append(ranges[i].runs, run);
  return are_compact(ranges, triangles.cols()) ? ranges : std::vector<VertexRange>();
}

}  // namespace foldless
