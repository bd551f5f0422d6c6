// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "core/energy/element.h"
#include "core/linear/buffer.h"
#include "core/threads/team.h"
#include "core/threads/unfilled_vector.h"

namespace foldless {

/// Triangles that a thread takes together: some tens of microseconds.
constexpr std::ptrdiff_t kTrianglesTogether = 512;

/// Calls visit(t) for every triangle, by the team of this thread; one without helpers, or with few
/// triangles, does it alone.
template <class Visit>
void for_triangles(std::ptrdiff_t count, const Visit& visit) {
  each_in_ranges(count, kTrianglesTogether, visit);
}

/// The least of bound(t, least) over all triangles, `least` that of some of the others; infinite
/// where there is none.
template <class Bound>
double least_of_triangles(std::ptrdiff_t count, const Bound& bound) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::atomic<double> least = kInfinity;
  in_ranges(count, kTrianglesTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    double own = least.load(std::memory_order_relaxed);
    for (std::ptrdiff_t t = begin; t < end; ++t) own = std::min(own, bound(t, own));
    double known = least.load(std::memory_order_relaxed);
    while (own < known && !least.compare_exchange_weak(known, own, std::memory_order_relaxed)) {
    }
  });
  return least;
}

/// Whether holds(t) for all triangles.
template <class Holds>
bool all_triangles(std::ptrdiff_t count, const Holds& holds) {
  std::atomic<bool> all = true;
  in_ranges(count, kTrianglesTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    for (std::ptrdiff_t t = begin; t < end && all.load(std::memory_order_relaxed); ++t)
      if (!holds(t)) all.store(false, std::memory_order_relaxed);
  });
  return all;
}

/// The triangles of which condition(t) holds, in their order.
template <class Condition>
std::vector<int> triangles_where(std::ptrdiff_t count, const Condition& condition) {
  std::vector<char> holds(static_cast<std::size_t>(count));
  for_triangles(count, [&](std::ptrdiff_t t) {
    holds[static_cast<std::size_t>(t)] = condition(static_cast<int>(t));
  });
  std::vector<int> triangles;
  for (std::size_t t = 0; t < holds.size(); ++t)
    if (holds[t]) triangles.push_back(static_cast<int>(t));
  return triangles;
}

/// The corners of triangles at every vertex, so that sums over the triangles round a vertex are
/// taken by one thread, in the order in which a loop over all triangles takes them.
class CornersOfVertices {
 public:
  struct Corner {
    int triangle, corner;
  };

  void assign(const Triangles& triangles, std::size_t vertices);
  void clear() { start_.clear(); }
  bool is_empty() const { return start_.empty(); }
  std::ptrdiff_t vertices() const { return static_cast<std::ptrdiff_t>(start_.size()) - 1; }
  /// Sorted by triangles.
  std::span<const Corner> of(std::ptrdiff_t v) const {
    const auto i = static_cast<std::size_t>(v);
    return std::span(corners_).subspan(start_[i], start_[i + 1] - start_[i]);
  }
  /// How many corners are those of vertices before v.
  std::size_t before(std::ptrdiff_t v) const { return start_[static_cast<std::size_t>(v)]; }

 private:
  std::vector<std::size_t> start_;  ///< #V + 1
  UnfilledVector<Corner> corners_;
};

/// Room that is used again, and that a copy makes for itself. Nothing is written there before the
/// threads do it: clearing the elements of a million triangles takes a second.
template <class Value>
class Scratch {
 public:
  Scratch() = default;
  Scratch(const Scratch&) {}
  Scratch& operator=(const Scratch&) { return *this; }

  /// Room for so many values.
  Value* of_size(std::size_t size) const {
    room_.reserve(size);
    return reinterpret_cast<Value*>(room_.data());
  }

 private:
  static_assert(std::is_trivially_copyable_v<Value>);
  struct Room {
    alignas(Value) std::byte bytes[sizeof(Value)];
  };
  mutable Buffer<Room> room_;
};

}  // namespace foldless
