// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/depth/overlap_pieces.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>

namespace foldless {
namespace {

std::size_t place_in(int index) { return static_cast<std::size_t>(index); }

/// Sets of pairs that grow together; every pair knows whether it is swapped against the first of
/// its set.
class PairSets {
 public:
  explicit PairSets(std::size_t count)
      : parent_(count), is_swapped_(count, false), is_one_sided_(count, false) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  struct Place {
    int set = 0;
    bool is_swapped = false;
  };

  Place find(int pair) {
    Place place{pair, false};
    while (parent_[place_in(place.set)] != place.set) {
      place.is_swapped = place.is_swapped != is_swapped_[place_in(place.set)];
      place.set = parent_[place_in(place.set)];
    }
    // The way is short from now on, for all on it.
    for (Place next{pair, place.is_swapped}; parent_[place_in(next.set)] != next.set;) {
      const Place here = next;
      next = {parent_[place_in(here.set)], here.is_swapped != is_swapped_[place_in(here.set)]};
      parent_[place_in(here.set)] = place.set;
      is_swapped_[place_in(here.set)] = here.is_swapped;
    }
    return place;
  }

  void unite(int first, int second, bool are_swapped) {
    const Place a = find(first), b = find(second);
    const bool is_swapped = (a.is_swapped != b.is_swapped) != are_swapped;
    if (a.set == b.set) {
      if (is_swapped) is_one_sided_[place_in(a.set)] = true;
      return;
    }
    parent_[place_in(b.set)] = a.set;
    is_swapped_[place_in(b.set)] = is_swapped;
    if (is_one_sided_[place_in(b.set)]) is_one_sided_[place_in(a.set)] = true;
  }

  bool is_one_sided(int set) const { return is_one_sided_[place_in(set)]; }

 private:
  std::vector<int> parent_;
  std::vector<bool> is_swapped_;  ///< against the parent
  std::vector<bool> is_one_sided_;
};

/// One triangle of a pair, seen from the other, which stays.
struct Side {
  int stays = 0;
  int pair = 0;
  bool stays_first = false;  ///< is `a` of the pair

  int goes(std::span<const Overlap> overlaps) const {
    const Overlap& overlap = overlaps[place_in(pair)];
    return stays_first ? overlap.b : overlap.a;
  }
};

std::vector<Side> sides_of(std::span<const Overlap> overlaps) {
  std::vector<Side> sides;
  sides.reserve(2 * overlaps.size());
  for (int i = 0; i < static_cast<int>(overlaps.size()); ++i) {
    sides.push_back({overlaps[place_in(i)].a, i, true});
    sides.push_back({overlaps[place_in(i)].b, i, false});
  }
  std::ranges::stable_sort(sides, {}, &Side::stays);
  return sides;
}

/// An edge of the triangle that goes.
struct Way {
  Edge edge;
  const Side* side;
};

void unite_over_edges(std::span<const Side> sides, const Triangles& triangles,
                      std::span<const Overlap> overlaps, PairSets& sets) {
  std::vector<Way> ways;
  for (const Side& side : sides) {
    const Eigen::Vector3i t = triangles.col(side.goes(overlaps));
    for (int k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
      ways.push_back({{a, b}, &side});
    }
  }
  std::ranges::sort(ways, {}, &Way::edge);
  for (std::size_t i = 1; i < ways.size(); ++i) {
    const Side &before = *ways[i - 1].side, &here = *ways[i].side;
    if (ways[i - 1].edge == ways[i].edge)
      sets.unite(before.pair, here.pair, before.stays_first != here.stays_first);
  }
}

}  // namespace

OverlapPieces overlap_pieces(const Triangles& triangles, std::span<const Overlap> overlaps) {
  PairSets sets(overlaps.size());
  const std::vector<Side> sides = sides_of(overlaps);
  for (std::size_t first = 0, end = 0; first < sides.size(); first = end) {
    while (end < sides.size() && sides[end].stays == sides[first].stays) ++end;
    unite_over_edges(std::span(sides).subspan(first, end - first), triangles, overlaps, sets);
  }
  OverlapPieces pieces;
  std::vector<int> number(overlaps.size(), -1);
  for (int pair = 0; pair < static_cast<int>(overlaps.size()); ++pair) {
    const PairSets::Place place = sets.find(pair);
    if (number[place_in(place.set)] < 0) {
      number[place_in(place.set)] = pieces.count++;
      pieces.is_one_sided.push_back(sets.is_one_sided(place.set));
    }
    pieces.piece.push_back(number[place_in(place.set)]);
    pieces.is_swapped.push_back(place.is_swapped);
  }
  return pieces;
}

}  // namespace foldless
