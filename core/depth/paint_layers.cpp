// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/depth/paint_layers.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/depth/overlap_pieces.h"

namespace foldless {
namespace {

/// Depths that differ by less than this part of their range are equal: they came from a solve.
constexpr double kEqualDepths = 1e-6;

std::size_t slot(int index) { return static_cast<std::size_t>(index); }

/// Sums over a piece of what is in front by so much: `a` of its sheets before `b`.
struct Lead {
  double depth = 0, order = 0, pairs = 0;
};

/// For every pair whether its `a` is in front of its `b`.
std::vector<bool> is_a_in_front(std::span<const Overlap> overlaps, const OverlapPieces& pieces,
                                const PaintKeys& keys) {
  const double range = keys.depth.maxCoeff() - keys.depth.minCoeff();
  const auto is_in_front = [range](const Lead& lead) {
    if (std::abs(lead.depth) > kEqualDepths * range * lead.pairs) return lead.depth > 0;
    return lead.order > 0;
  };
  const auto lead_of = [&](std::size_t pair) {
    const Overlap& o = overlaps[pair];
    const double sign = pieces.is_swapped[pair] ? -1 : 1;
    return Lead{sign * (keys.depth[o.a] - keys.depth[o.b]),
                sign * (keys.order[o.a] - keys.order[o.b]), 1};
  };
  std::vector<Lead> leads(slot(pieces.count));
  for (std::size_t pair = 0; pair < overlaps.size(); ++pair) {
    if (overlaps[pair].is_contact) continue;
    const Lead one = lead_of(pair);
    Lead& sum = leads[slot(pieces.piece[pair])];
    sum = {sum.depth + one.depth, sum.order + one.order, sum.pairs + 1};
  }
  std::vector<bool> in_front(overlaps.size());
  for (std::size_t pair = 0; pair < overlaps.size(); ++pair) {
    const bool alone = pieces.is_one_sided[slot(pieces.piece[pair])];
    const Lead lead = alone ? lead_of(pair) : leads[slot(pieces.piece[pair])];
    in_front[pair] = is_in_front(lead) != pieces.is_swapped[pair];
  }
  return in_front;
}

/// The other triangle of a pair.
struct Neighbour {
  int triangle = 0;
  bool is_in_front = false;
};

/// The triangles that overlap each, one after another.
struct Neighbours {
  std::vector<int> first;
  std::vector<Neighbour> all;
  std::vector<int> below;  ///< of every triangle, how many are to be painted before it

  std::span<const Neighbour> of(int t) const {
    return std::span(all).subspan(slot(first[slot(t)]), slot(first[slot(t) + 1] - first[slot(t)]));
  }
};

Neighbours neighbours_of(std::span<const Overlap> overlaps, const std::vector<bool>& a_in_front,
                         int count) {
  Neighbours neighbours;
  neighbours.first.assign(slot(count) + 1, 0);
  neighbours.below.assign(slot(count), 0);
  for (std::size_t i = 0; i < overlaps.size(); ++i) {
    if (overlaps[i].is_contact) continue;
    ++neighbours.first[slot(overlaps[i].a) + 1];
    ++neighbours.first[slot(overlaps[i].b) + 1];
    ++neighbours.below[slot(a_in_front[i] ? overlaps[i].a : overlaps[i].b)];
  }
  for (std::size_t t = 1; t < neighbours.first.size(); ++t)
    neighbours.first[t] += neighbours.first[t - 1];
  neighbours.all.resize(slot(neighbours.first.back()));
  std::vector<int> next(neighbours.first.begin(), neighbours.first.end() - 1);
  for (std::size_t i = 0; i < overlaps.size(); ++i) {
    const auto [a, b, is_contact] = overlaps[i];
    if (is_contact) continue;
    neighbours.all[slot(next[slot(a)]++)] = {b, !a_in_front[i]};
    neighbours.all[slot(next[slot(b)]++)] = {a, a_in_front[i]};
  }
  return neighbours;
}

/// Triangles with something below them, from back to front by the keys.
std::vector<int> by_keys(const std::vector<int>& below, const PaintKeys& keys) {
  std::vector<int> triangles;
  for (int t = 0; t < static_cast<int>(below.size()); ++t)
    if (below[slot(t)] > 0) triangles.push_back(t);
  std::ranges::sort(triangles, {},
                    [&](int t) { return std::tuple(keys.depth[t], keys.order[t], t); });
  return triangles;
}

}  // namespace

std::vector<int> paint_layers(const Triangles& triangles, std::span<const Overlap> overlaps,
                              const PaintKeys& keys) {
  const int count = static_cast<int>(triangles.cols());
  std::vector<int> layers(slot(count), 0);
  if (overlaps.empty()) return layers;
  const OverlapPieces pieces = overlap_pieces(triangles, overlaps);
  Neighbours neighbours = neighbours_of(overlaps, is_a_in_front(overlaps, pieces, keys), count);
  const std::vector<int> waiting = by_keys(neighbours.below, keys);
  std::vector<bool> is_placed(slot(count), false);
  std::vector<int> ready;
  for (int t = 0; t < count; ++t)
    if (neighbours.below[slot(t)] == 0) ready.push_back(t);
  const auto place = [&](int t) {
    is_placed[slot(t)] = true;
    for (const Neighbour& other : neighbours.of(t)) {
      if (is_placed[slot(other.triangle)]) continue;
      layers[slot(other.triangle)] = std::max(layers[slot(other.triangle)], layers[slot(t)] + 1);
      if (other.is_in_front && --neighbours.below[slot(other.triangle)] == 0)
        ready.push_back(other.triangle);
    }
  };
  const auto place_ready = [&] {
    while (!ready.empty()) {
      const int t = ready.back();
      ready.pop_back();
      place(t);
    }
  };
  place_ready();
  for (const int t : waiting) {
    if (is_placed[slot(t)]) continue;
    place(t);  // in a circle
    place_ready();
  }
  return layers;
}

}  // namespace foldless
