// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/overlay.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace foldless {
namespace {

std::size_t slot(int index) { return static_cast<std::size_t>(index); }

bool chords_cross(const Edge& f, const Edge& s) {
  return (f[0] < s[0] && s[0] < f[1] && f[1] < s[1]) || (s[0] < f[0] && f[0] < s[1] && s[1] < f[1]);
}

/// A chord and the vertices on it, from its smaller corner to the other.
using Chains = std::map<Edge, std::vector<int>>;

/// The planar graph of corners and crossings.
class Arrangement {
 public:
  Arrangement(int corners, const Triangles& first, const Triangles& second) : corners_(corners) {
    const std::vector<Edge> chords = chords_of(corners, first), others = chords_of(corners, second);
    for (const Edge& chord : chords) chains_[chord] = {};
    for (const Edge& chord : others) chains_[chord] = {};
    for (const Edge& f : chords)
      for (const Edge& s : others)
        if (chords_cross(f, s)) add_crossing(f, s);
    for (auto& [chord, chain] : chains_) sort(chord, chain);
    for (int i = 0; i + 1 < corners; ++i) chains_[{i, i + 1}] = {};
    chains_[{0, corners - 1}] = {};
    for (auto& [chord, chain] : chains_) {
      chain.insert(chain.begin(), chord[0]);
      chain.push_back(chord[1]);
    }
  }

  Overlay overlay() const {
    Overlay result;
    for (std::size_t i = 0; i < crossed_.size(); ++i) {
      const auto& [f, s] = crossed_[i];
      const int vertex = corners_ + static_cast<int>(i);
      result.crossings.push_back({{f, place_on(f, vertex)}, {s, place_on(s, vertex)}});
    }
    result.faces = faces();
    return result;
  }

 private:
  using Crossed = std::pair<Edge, Edge>;  ///< a chord of the first triangulation and of the second

  const Crossed& crossed(int vertex) const { return crossed_[slot(vertex - corners_)]; }

  void add_crossing(const Edge& f, const Edge& s) {
    const int vertex = corners_ + static_cast<int>(crossed_.size());
    chains_[f].push_back(vertex);
    chains_[s].push_back(vertex);
    crossed_.emplace_back(f, s);
  }

  /// Chords that do not cross each other meet another in the order of their ends on either side.
  void sort(const Edge& chord, std::vector<int>& chain) const {
    const auto order = [&](int vertex) {
      const auto& [f, s] = crossed(vertex);
      const Edge& other = f == chord ? s : f;
      const bool is_first_inside = chord[0] < other[0] && other[0] < chord[1];
      const int inside = is_first_inside ? other[0] : other[1];
      const int outside = is_first_inside ? other[1] : other[0];
      return std::pair(inside, -((outside - chord[0] + corners_) % corners_));
    };
    std::ranges::sort(chain, {}, order);
  }

  double place_on(const Edge& chord, int vertex) const {
    const std::vector<int>& chain = chains_.at(chord);
    const auto before = std::ranges::find(chain, vertex) - chain.begin();
    return static_cast<double>(before) / static_cast<double>(chain.size() - 1);
  }

  /// The vertex that follows `vertex` on the chain of a chord towards one of its corners.
  int neighbour(int vertex, const Edge& chord, int towards) const {
    const std::vector<int>& chain = chains_.at(chord);
    const auto place = std::ranges::find(chain, vertex);
    return towards == chord[0] ? *(place - 1) : *(place + 1);
  }

  /// The neighbours of every vertex, counter-clockwise.
  std::vector<std::vector<int>> rings() const {
    std::vector<std::vector<std::pair<int, int>>> round(slot(corners_));  // way round, neighbour
    for (const auto& [chord, chain] : chains_) {
      const int way = chord[1] - chord[0];
      round[slot(chord[0])].emplace_back(way, chain[1]);
      round[slot(chord[1])].emplace_back(corners_ - way, chain[chain.size() - 2]);
    }
    std::vector<std::vector<int>> rings;
    for (auto& of_corner : round) {
      std::ranges::sort(of_corner);
      std::vector<int>& ring = rings.emplace_back();
      for (const auto& [way, vertex] : of_corner) ring.push_back(vertex);
    }
    for (std::size_t i = 0; i < crossed_.size(); ++i) {
      const auto& [f, s] = crossed_[i];
      const int vertex = corners_ + static_cast<int>(i);
      const bool is_first_lower = f[0] < s[0];
      const Edge &a = is_first_lower ? f : s, &b = is_first_lower ? s : f;
      rings.push_back({neighbour(vertex, a, a[0]), neighbour(vertex, b, b[0]),
                       neighbour(vertex, a, a[1]), neighbour(vertex, b, b[1])});
    }
    return rings;
  }

  std::vector<std::vector<int>> faces() const {
    const std::vector<std::vector<int>> around = rings();
    const auto next = [&](int from, int to) {  // the face is on the left of both
      const std::vector<int>& ring = around[slot(to)];
      const auto place = std::ranges::find(ring, from);
      return place == ring.begin() ? ring.back() : *(place - 1);
    };
    std::set<Edge> seen;                                                      // directed
    for (int i = 0; i < corners_; ++i) seen.insert({(i + 1) % corners_, i});  // the face outside
    std::vector<std::vector<int>> faces;
    for (int v = 0; v < static_cast<int>(around.size()); ++v)
      for (const int w : around[slot(v)]) {
        if (seen.contains({v, w})) continue;
        std::vector<int>& face = faces.emplace_back();
        int from = v, to = w;
        while (seen.insert({from, to}).second) {
          face.push_back(from);
          from = std::exchange(to, next(from, to));
        }
      }
    return faces;
  }

  int corners_;
  Chains chains_;
  std::vector<Crossed> crossed_;  ///< by vertex from `corners_` on
};

}  // namespace

Overlay overlay_of(int corners, const Triangles& first, const Triangles& second) {
  return Arrangement(corners, first, second).overlay();
}

int crossings_of(const Edge& chord, const std::vector<Edge>& chords) {
  return static_cast<int>(
      std::ranges::count_if(chords, [&](const Edge& other) { return chords_cross(chord, other); }));
}

std::vector<Edge> chords_of(int corners, const Triangles& triangles) {
  std::set<Edge> chords;
  for (const auto& t : triangles.colwise())
    for (const Edge& side : {Edge{t[0], t[1]}, Edge{t[1], t[2]}, Edge{t[0], t[2]}})
      if (side[1] - side[0] > 1 && side[1] - side[0] < corners - 1) chords.insert(side);
  return {chords.begin(), chords.end()};
}

}  // namespace foldless
