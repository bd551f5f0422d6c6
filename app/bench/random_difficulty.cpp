// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of difficulties(): how homeomorphisms and handles are drawn.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "app/bench/random_suite.h"

namespace foldless {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// How far the moves of free scenes go. Lengths in diagonals of the mesh.
struct Amplitude {
  int moves;
  double offset;       ///< largest, of drags and shears
  double least_twist;  ///< degrees
  double largest_twist;
  int least_handles;
  int largest_handles;
};

Vec2 direction(RandomNumbers& random) {
  const double angle = random.between(0, 2 * std::numbers::pi);
  return {std::cos(angle), std::sin(angle)};
}

int random_vertex(RandomNumbers& random, const RandomMesh& mesh) {
  return static_cast<int>(random.below(mesh.is_boundary.size()));
}

double distance_to(const std::vector<int>& vertices, const Points& points, const Vec2& p) {
  double distance = std::numeric_limits<double>::infinity();
  for (const int v : vertices) distance = std::min(distance, (points.col(v) - p).norm());
  return distance;
}

/// Handles to add, and how much more those that are moved much are liked.
struct Wish {
  int count;
  double pull;
};

/// Adds handles one by one, each the best of six random vertices: far from the others and, by the
/// pull, much moved. Vertices that `is_allowed` refuses are left out.
template <typename Allowed>
void add_handles(RandomNumbers& random, RandomDeformation& deformation, const Wish& wish,
                 const Allowed& is_allowed) {
  const Points& rest = deformation.mesh.shape.rest;
  std::vector<int> chosen;
  for (int i = 0; i < wish.count; ++i) {
    std::optional<int> best;
    double best_score = 0;
    for (int attempt = 0; attempt < 6; ++attempt) {
      const int v = random_vertex(random, deformation.mesh);
      if (!is_allowed(v)) continue;
      const Vec2 p = rest.col(v);
      const double room = std::min(distance_to(chosen, rest, p), deformation.mesh.diagonal);
      const double score = room + wish.pull * (deformation.map(p) - p).norm();
      if (room > 0 && score > best_score) {
        best_score = score;
        best = v;
      }
    }
    if (best) chosen.push_back(*best);
  }
  deformation.handles.insert(deformation.handles.end(), chosen.begin(), chosen.end());
}

void add_free_move(RandomNumbers& random, RandomDeformation& deformation,
                   const Amplitude& amplitude) {
  const RandomMesh& mesh = deformation.mesh;
  const Vec2 centre = mesh.shape.rest.col(random_vertex(random, mesh));
  const double D = mesh.diagonal;
  const double offset = D * random.between(0.4, 1) * amplitude.offset;
  const double twist = random.between(amplitude.least_twist, amplitude.largest_twist) * kDegree;
  switch (random.below(5)) {
    case 0:
      deformation.map.moves.emplace_back(
          Shear{centre, offset * direction(random), D * random.between(0.15, 0.4)});
      break;
    case 1:
    case 2: {
      const double radius = D * random.between(0.2, 0.5);
      deformation.map.moves.emplace_back(
          Twist{centre, radius, radius * random.between(0, 0.5), random.sign() * twist});
      break;
    }
    default:
      add_long_drag(deformation.map,
                    {centre, D * random.between(0.2, 0.45), offset * direction(random)});
  }
}

bool draw_free(RandomNumbers& random, RandomDeformation& deformation, const Amplitude& amplitude) {
  for (int i = 0; i < amplitude.moves; ++i) add_free_move(random, deformation, amplitude);
  const int count = random.integer(amplitude.least_handles, amplitude.largest_handles);
  add_handles(random, deformation, {count, 0.5}, [](int) { return true; });
  return true;
}

bool draw_easy(RandomNumbers& random, RandomDeformation& deformation) {
  return draw_free(random, deformation, {2, 0.12, 10, 50, 3, 6});
}

bool draw_medium(RandomNumbers& random, RandomDeformation& deformation) {
  return draw_free(random, deformation, {3, 0.25, 40, 110, 4, 8});
}

bool draw_hard(RandomNumbers& random, RandomDeformation& deformation) {
  return draw_free(random, deformation, {6, 0.7, 120, 300, 8, 12});
}

/// An interior vertex, the one of most clearance among a few.
int roomy_vertex(RandomNumbers& random, const RandomMesh& mesh, int attempts) {
  int best = random_vertex(random, mesh);
  for (int i = 1; i < attempts; ++i) {
    const int v = random_vertex(random, mesh);
    const auto clearance = [&](int w) { return mesh.clearance[static_cast<std::size_t>(w)]; };
    if (clearance(v) > clearance(best)) best = v;
  }
  return best;
}

void add_inner_move(RandomNumbers& random, RandomDeformation& deformation) {
  const RandomMesh& mesh = deformation.mesh;
  const int v = roomy_vertex(random, mesh, 4);
  const Vec2 centre = mesh.shape.rest.col(v);
  const double room = 0.98 * mesh.clearance[static_cast<std::size_t>(v)];
  if (room <= 0) return;
  if (random.below(2) == 0) {
    // One draw a statement: the order of operands is the compiler's choice.
    const double sign = random.sign();
    const double angle = sign * random.between(60, 240) * kDegree;
    deformation.map.moves.emplace_back(Twist{centre, room, room * random.between(0, 0.4), angle});
  } else {
    add_long_drag(deformation.map, {centre, room / 2, room / 2 * direction(random)});
  }
}

void hold_boundary(RandomDeformation& deformation) {
  const std::vector<bool>& is_boundary = deformation.mesh.is_boundary;
  for (std::size_t v = 0; v < is_boundary.size(); ++v)
    if (is_boundary[v]) deformation.handles.push_back(static_cast<int>(v));
}

bool draw_fixed_boundary(RandomNumbers& random, RandomDeformation& deformation) {
  const int moves = random.integer(4, 12);
  for (int i = 0; i < moves; ++i) add_inner_move(random, deformation);
  hold_boundary(deformation);
  const std::size_t held = deformation.handles.size();
  add_handles(random, deformation, {random.integer(3, 10), 3},
              [&](int v) { return !deformation.mesh.is_boundary[static_cast<std::size_t>(v)]; });
  return deformation.handles.size() >= held + 3;
}

/// A second vertex about so far from the first.
int partner_of(RandomNumbers& random, const RandomMesh& mesh, int first, double distance) {
  const Points& rest = mesh.shape.rest;
  int best = first;
  double best_miss = std::numeric_limits<double>::infinity();
  for (int attempt = 0; attempt < 40; ++attempt) {
    const int v = random_vertex(random, mesh);
    const double miss = std::abs((rest.col(v) - rest.col(first)).norm() - distance);
    if (v == first || miss >= best_miss) continue;
    best = v;
    best_miss = miss;
  }
  return best;
}

/// Half a turn about the middle of two vertices, where the moves so far have taken them.
void exchange(RandomNumbers& random, PlaneMap& map, const Vec2& p, const Vec2& q) {
  const Vec2 a = map(p);
  const Vec2 b = map(q);
  const double half = (a - b).norm() / 2;
  map.moves.emplace_back(Twist{(a + b) / 2, half * random.between(1.6, 2.4), half * 1.05,
                               random.sign() * std::numbers::pi});
}

bool draw_crossing(RandomNumbers& random, RandomDeformation& deformation) {
  const RandomMesh& mesh = deformation.mesh;
  const int pairs = random.integer(2, 4);
  const auto is_new = [&](int v) {
    return std::ranges::find(deformation.handles, v) == deformation.handles.end();
  };
  for (int i = 0; i < pairs; ++i) {
    const int a = random_vertex(random, mesh);
    const int b = partner_of(random, mesh, a, mesh.diagonal * random.between(0.08, 0.3));
    if (a == b || !is_new(a) || !is_new(b)) continue;
    exchange(random, deformation.map, mesh.shape.rest.col(a), mesh.shape.rest.col(b));
    deformation.handles.push_back(a);
    deformation.handles.push_back(b);
  }
  if (deformation.handles.empty()) return false;
  add_handles(random, deformation, {random.integer(1, 4), 0}, is_new);
  return true;
}

bool draw_swirl(RandomNumbers& random, RandomDeformation& deformation) {
  const RandomMesh& mesh = deformation.mesh;
  const Points& rest = mesh.shape.rest;
  const int middle = roomy_vertex(random, mesh, 12);
  const Vec2 centre = rest.col(middle);
  const double radius = mesh.clearance[static_cast<std::size_t>(middle)] * random.between(0.8, 1);
  const double core = radius * random.between(0.25, 0.5);
  deformation.map.moves.emplace_back(Twist{centre, radius, core, random.sign() * std::numbers::pi});
  hold_boundary(deformation);
  const std::size_t held = deformation.handles.size();
  std::size_t untouched = 0;
  for (int v = 0; v < rest.cols(); ++v) {
    if (mesh.is_boundary[static_cast<std::size_t>(v)]) continue;
    if ((rest.col(v) - centre).norm() <= core)
      deformation.handles.push_back(v);
    else
      ++untouched;
  }
  const std::size_t turned = deformation.handles.size() - held;
  return turned >= 4 && untouched >= turned;
}

constexpr std::array kDifficulties{
    Difficulty{"easy", draw_easy},         Difficulty{"medium", draw_medium},
    Difficulty{"hard", draw_hard},         Difficulty{"fixed-boundary", draw_fixed_boundary},
    Difficulty{"crossing", draw_crossing}, Difficulty{"swirl", draw_swirl},
};

}  // namespace

std::span<const Difficulty> difficulties() { return kDifficulties; }

}  // namespace foldless
