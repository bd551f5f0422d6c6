// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/carried_curves.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "core/construct/directed_edge.h"
#include "core/construct/in_circle.h"
#include "core/mesh/orientation.h"

namespace foldless {
namespace {

/// Rounding must not flip an edge for ever.
constexpr int kMostSweepsOfFlips = 1000;

std::size_t nth(int index) { return static_cast<std::size_t>(index); }

/// Beyond rounding: a flip that is left out does no harm.
bool is_clearly_positive(const Vec2& a, const Vec2& b, const Vec2& c) {
  constexpr double kLeastPart = 1e-12;
  return signed_area(a, b, c) > kLeastPart * ((b - a).squaredNorm() + (c - a).squaredNorm());
}

}  // namespace

CarriedCurves::CarriedCurves(const std::vector<Eigen::Vector3i>& triangles, Points positions)
    : positions_(std::move(positions)) {
  std::unordered_map<std::uint64_t, int> half_edges;
  for (const Eigen::Vector3i& t : triangles)
    for (int i = 0; i < 3; ++i) {
      half_edges[directed_edge(t[i], t[(i + 1) % 3])] = static_cast<int>(origins_.size());
      origins_.push_back(t[i]);
    }
  twins_.assign(origins_.size(), -1);
  edges_.assign(origins_.size(), -1);
  for (int h = 0; h < static_cast<int>(origins_.size()); ++h) {
    const auto found = half_edges.find(directed_edge(origin(next(h)), origin(h)));
    if (found != half_edges.end()) twins_[nth(h)] = found->second;
    if (found != half_edges.end() && found->second < h) {
      edges_[nth(h)] = edges_[nth(found->second)];
      line(h).lying = static_cast<int>(curves_.size());
      curves_.push_back({~origin(h), ~origin(next(h)), origin(next(h)), origin(h)});
    } else {
      edges_[nth(h)] = static_cast<int>(lines_.size());
      lines_.emplace_back(Line{.tail = origin(h)});
    }
  }
}

bool CarriedCurves::move_to(const Points& positions) {
  std::vector<bool> has_moved(origins_.size() / 3);
  for (int h = 0; h < static_cast<int>(origins_.size()); h += 3) {
    const int a = origin(h), b = origin(h + 1), c = origin(h + 2);
    const auto stays = [&](int v) { return positions.col(v) == positions_.col(v); };
    if (stays(a) && stays(b) && stays(c)) continue;
    has_moved[nth(h / 3)] = true;
    if (orientation(positions.col(a), positions.col(b), positions.col(c)) <= 0) return false;
  }
  positions_ = positions;
  make_delaunay(std::move(has_moved));
  return true;
}

std::vector<CarriedCurves::Curve> CarriedCurves::curves() const {
  std::vector<Vec2> places(crossings_.size());
  for (int h = 0; h < static_cast<int>(origins_.size()); ++h) {
    const std::vector<int>& crossings = line(h).crossings;
    if (line(h).tail != origin(h)) continue;
    const Vec2 a = positions_.col(origin(h)), b = positions_.col(origin(next(h)));
    for (std::size_t i = 0; i < crossings.size(); ++i)
      places[nth(crossings[i])] =
          a + static_cast<double>(i + 1) / static_cast<double>(crossings.size() + 1) * (b - a);
  }
  std::vector<Curve> curves;
  for (const Ends& ends : curves_) {
    std::vector<int> crossed;
    for (Place place = ends.first; place >= 0; place = crossings_[nth(place)].after)
      crossed.push_back(place);
    Curve& curve = curves.emplace_back(
        Curve{ends.from, ends.to, Points(2, static_cast<Eigen::Index>(crossed.size()))});
    for (std::size_t i = 0; i < crossed.size(); ++i)
      curve.bends.col(static_cast<Eigen::Index>(i)) = places[nth(crossed[i])];
  }
  return curves;
}

CarriedCurves::Quadrilateral CarriedCurves::quadrilateral(int diagonal) const {
  const int back = twin(diagonal);
  return {.ab = next(back), .bc = before(back), .cd = next(diagonal), .da = before(diagonal)};
}

void CarriedCurves::make_delaunay(std::vector<bool> changed) {
  for (int sweep = 0; sweep < kMostSweepsOfFlips; ++sweep) {
    std::vector<bool> flipped(changed.size());
    bool has_flipped = false;
    for (int h = 0; h < static_cast<int>(origins_.size()); ++h) {
      const int back = twin(h);
      if (back < h || (!changed[nth(h / 3)] && !changed[nth(back / 3)]) ||
          !is_better_flipped(quadrilateral(h)))
        continue;
      flip(h);
      has_flipped = true;
      for (auto* triangles : {&changed, &flipped})
        (*triangles)[nth(h / 3)] = (*triangles)[nth(back / 3)] = true;
    }
    if (!has_flipped) return;
    changed = std::move(flipped);
  }
}

bool CarriedCurves::is_better_flipped(const Quadrilateral& q) const {
  const Vec2 a = positions_.col(origin(q.ab)), b = positions_.col(origin(q.bc)),
             c = positions_.col(origin(q.cd)), d = positions_.col(origin(q.da));
  return is_in_circle(a, c, d, b) && is_clearly_positive(a, b, d) && is_clearly_positive(b, c, d);
}

void CarriedCurves::flip(int diagonal) {
  const Quadrilateral q = quadrilateral(diagonal);
  lead_over(line(diagonal), q);
  flip_triangles(diagonal, q);
}

// Strands with one end on the way by a and one on that by c cross the new diagonal, in the order of
// their ends.
void CarriedCurves::lead_over(Line& flipped, const Quadrilateral& q) {
  mark_sides(q);
  find_strands(q, flipped);
  for (const int crossing : flipped.crossings) remove_crossing(crossing);
  flipped = Line{.tail = origin(q.bc)};
  std::vector<std::pair<std::pair<int, int>, int>> crossed;  // ranks by a and by c, crossing
  for (const Strand& strand : strands_) {
    const Rank before = rank_of(strand.before, q), after = rank_of(strand.after, q);
    if (before.by == Rank::By::neither || after.by == Rank::By::neither || before.by == after.by) {
      join(strand.curve, strand.before, strand.after);
      if (strand.before < 0 && strand.after < 0) flipped.lying = strand.curve;
      continue;
    }
    const int crossing = add_crossing(strand);
    crossed.push_back({before.by == Rank::By::a ? std::pair(before.rank, after.rank)
                                                : std::pair(after.rank, before.rank),
                       crossing});
  }
  unmark_sides();
  std::ranges::sort(crossed);
  for (const auto& [ranks, crossing] : crossed) flipped.crossings.push_back(crossing);
}

// The half-edges of the diagonal keep their numbers, and its triangles theirs.
void CarriedCurves::flip_triangles(int diagonal, const Quadrilateral& q) {
  const int back = twin(diagonal), b = origin(q.bc), d = origin(q.da);
  const std::array sides{q.ab, q.bc, q.cd, q.da};
  std::array<int, 4> twins{}, edges{}, origins{};
  for (std::size_t i = 0; i < 4; ++i) {
    twins[i] = twin(sides[i]);
    edges[i] = edges_[nth(sides[i])];
    origins[i] = origin(sides[i]);
  }
  const auto put = [&](int h, std::size_t side) {
    origins_[nth(h)] = origins[side];
    twins_[nth(h)] = twins[side];
    edges_[nth(h)] = edges[side];
    if (twins[side] >= 0) twins_[nth(twins[side])] = h;
  };
  origins_[nth(diagonal)] = d;
  put(next(diagonal), 1);
  put(next(next(diagonal)), 2);
  origins_[nth(back)] = b;
  put(next(back), 3);
  put(next(next(back)), 0);
}

void CarriedCurves::mark_sides(const Quadrilateral& q) {
  by_a_.clear();
  by_c_.clear();
  mark_side(origin(q.bc), q.ab, Rank::By::a);
  rank_of_a_ = {Rank::By::a, static_cast<int>(by_a_.size())};
  by_a_.push_back(~origin(q.ab));
  mark_side(origin(q.ab), q.da, Rank::By::a);
  mark_side(origin(q.bc), q.bc, Rank::By::c);
  rank_of_c_ = {Rank::By::c, static_cast<int>(by_c_.size())};
  by_c_.push_back(~origin(q.cd));
  mark_side(origin(q.cd), q.cd, Rank::By::c);
}

void CarriedCurves::mark_side(int from, int side, Rank::By by) {
  const Line& crossed = line(side);
  std::vector<Place>& way = by == Rank::By::a ? by_a_ : by_c_;
  const auto mark = [&](int crossing) {
    ranks_[nth(crossing)] = {by, static_cast<int>(way.size())};
    way.push_back(crossing);
  };
  if (crossed.tail == from)
    std::for_each(crossed.crossings.begin(), crossed.crossings.end(), mark);
  else
    std::for_each(crossed.crossings.rbegin(), crossed.crossings.rend(), mark);
}

void CarriedCurves::unmark_sides() {
  for (const auto* way : {&by_a_, &by_c_})
    for (const Place place : *way)
      if (place >= 0) ranks_[nth(place)] = {};
}

CarriedCurves::Rank CarriedCurves::rank_of(Place place, const Quadrilateral& q) const {
  if (place >= 0) return ranks_[nth(place)];
  if (place == ~origin(q.ab)) return rank_of_a_;
  if (place == ~origin(q.cd)) return rank_of_c_;
  return {};
}

void CarriedCurves::find_strands(const Quadrilateral& q, const Line& diagonal) {
  const int a = origin(q.ab);
  strands_.clear();
  for (const int crossing : diagonal.crossings) {
    const Crossing& c = crossings_[nth(crossing)];
    strands_.push_back({c.curve, c.before, c.after});
  }
  if (diagonal.lying >= 0) {
    const Ends& ends = curves_[nth(diagonal.lying)];
    strands_.push_back({diagonal.lying, ~ends.from, ~ends.to});
  }
  // Those that do not cross the diagonal that was: round b and d, to c, and from a.
  for (const Place crossing : by_a_) {
    if (crossing < 0) continue;
    const Crossing& c = crossings_[nth(crossing)];
    if (rank_of(c.before, q).by == Rank::By::c) strands_.push_back({c.curve, c.before, crossing});
    if (rank_of(c.after, q).by == Rank::By::c) strands_.push_back({c.curve, crossing, c.after});
  }
  for (const Place crossing : by_c_) {
    if (crossing < 0) continue;
    const Crossing& c = crossings_[nth(crossing)];
    if (c.before == ~a) strands_.push_back({c.curve, c.before, crossing});
    if (c.after == ~a) strands_.push_back({c.curve, crossing, c.after});
  }
}

int CarriedCurves::add_crossing(const Strand& strand) {
  int crossing = static_cast<int>(crossings_.size());
  if (free_.empty()) {
    crossings_.emplace_back();
    ranks_.emplace_back();
  } else {
    crossing = free_.back();
    free_.pop_back();
  }
  crossings_[nth(crossing)] = {strand.curve, strand.before, strand.after};
  join(strand.curve, strand.before, crossing);
  join(strand.curve, crossing, strand.after);
  return crossing;
}

void CarriedCurves::remove_crossing(int crossing) { free_.push_back(crossing); }

void CarriedCurves::join(int curve, Place before, Place after) {
  (before >= 0 ? crossings_[nth(before)].after : curves_[nth(curve)].first) = after;
  (after >= 0 ? crossings_[nth(after)].before : curves_[nth(curve)].last) = before;
}

}  // namespace foldless
