// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "core/construct/cut_disk.h"
#include "core/construct/directed_edge.h"

namespace foldless {
namespace {

constexpr double kUnreachable = std::numeric_limits<double>::infinity();
/// Of a vertex inside, from which ways begin.
constexpr std::uint64_t kStart = ~std::uint64_t{0};
/// What crossing an edge costs, as it makes vertices and leaves less room for what comes later:
/// in diagonals, and in diagonals by diagonals a width.
constexpr double kCostOfCrossing = 0.03;
constexpr double kCostOfNarrowness = 0.002;

std::size_t place_of(int vertex) { return static_cast<std::size_t>(vertex); }

int from_of(std::uint64_t key) { return static_cast<int>(key >> 32); }
int to_of(std::uint64_t key) { return static_cast<int>(key & 0xffffffffU); }

}  // namespace

double CutDisk::Ways::cost(int corner) const {
  const auto found = corners_.find(corner);
  return found == corners_.end() ? kUnreachable : found->second.cost;
}

/// Dijkstra's algorithm over middles of edges.
class CutDisk::Search {
 public:
  Search(const CutDisk& disk, int from) : disk_(disk), from_(from) {}

  Ways ways() {
    for (const Eigen::Vector3i& t : disk_.triangles_)
      for (int i = 0; i < 3; ++i)
        if (t[i] == from_) begin_across(t[(i + 1) % 3], t[(i + 2) % 3]);
    while (!queue_.empty()) {
      const auto [cost, edge] = queue_.top();
      queue_.pop();
      if (cost <= ways_.edges_.at(edge).cost) go_on(cost, edge);
    }
    for (auto& [corner, reached] : ways_.corners_) reached.cost /= disk_.diagonal_;
    return std::move(ways_);
  }

 private:
  using Entry = std::pair<double, std::uint64_t>;

  void begin_across(int a, int b) {
    const Vec2 start = disk_.position(from_);
    reach_corner(a, {(disk_.position(a) - start).norm(), kStart});
    reach_edge(a, b, {(middle(a, b) - start).norm(), kStart});
  }

  void go_on(double cost, std::uint64_t edge) {
    const int a = from_of(edge), b = to_of(edge), x = disk_.opposite(disk_.left_of(b, a), b, a);
    if (x == from_) return;
    const Vec2 here = middle(a, b);
    reach_corner(x, {cost + (disk_.position(x) - here).norm(), edge});
    reach_edge(a, x, {cost + (middle(a, x) - here).norm(), edge});
    reach_edge(x, b, {cost + (middle(x, b) - here).norm(), edge});
  }

  void reach_corner(int v, const Ways::Reached& reached) {
    if (!disk_.is_on_outline_[place_of(v)]) return;
    const auto [place, is_new] = ways_.corners_.try_emplace(v, reached);
    if (reached.cost < place->second.cost) place->second = reached;
  }

  void reach_edge(int a, int b, Ways::Reached reached) {
    if (disk_.left_of(b, a) < 0) return;
    const double D = disk_.diagonal_, width = (disk_.position(a) - disk_.position(b)).norm();
    reached.cost += kCostOfCrossing * D + kCostOfNarrowness * D * D / width;
    const auto [place, is_new] = ways_.edges_.try_emplace(directed_edge(a, b), reached);
    if (!is_new && place->second.cost <= reached.cost) return;
    place->second = reached;
    queue_.emplace(reached.cost, directed_edge(a, b));
  }

  Vec2 middle(int a, int b) const { return 0.5 * (disk_.position(a) + disk_.position(b)); }

  const CutDisk& disk_;
  int from_;
  Ways ways_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

CutDisk::Ways CutDisk::ways_to(int v) const { return Search(*this, v).ways(); }

// It begins where it first comes by its corner.
CutDisk::Way CutDisk::way_from(int corner, const Ways& ways) const {
  Way way{corner, {}};
  for (std::uint64_t at = ways.corners_.at(corner).before; at != kStart;
       at = ways.edges_.at(at).before) {
    const int a = from_of(at), b = to_of(at);
    if (opposite(left_of(b, a), b, a) == corner) way.crossed.clear();
    way.crossed.push_back({a, b});
  }
  return way;
}

}  // namespace foldless
