// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/braids.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/construct/carried_curves.h"
#include "core/construct/curve_energy.h"
#include "core/construct/curve_slits.h"
#include "core/construct/cut_disk.h"
#include "core/construct/random_numbers.h"

namespace foldless {
namespace {

/// A motion takes at least so many steps,
constexpr int kStepsOfAMotion = 8;
/// each of which is halved so often where triangles would fold.
constexpr int kMostHalvings = 12;
/// A search begins so often: from the same motion, but for what is drawn, it ends elsewhere.
constexpr int kBeginnings = 4;
/// So many motions are tried from each at most, and fewer the more vertices there are: what one
/// takes grows with their square. Half as many in all searches but the first.
constexpr int kMostTries = 400;
constexpr int kTriesTimesVerticesSquared = 2'000'000;
/// The first motion goes this part of a way beside it at most, for points may meet on straight
/// ways.
constexpr double kFirstDetour = 0.02;
/// The least time of a point, of all.
constexpr double kLeastTime = 0.1;
/// The part of the tries that change both the way of a point and its time; the others change one.
constexpr double kBothChange = 0.2;

/// How points go, a column each: halfway each is off the middle of its way by a detour, and goes
/// straight from there and to there.
struct Motion {
  Points detours;
  Points times;  ///< of departure and arrival, within 0 to 1
};

Points with_points_inside(const DottedDisk& disk) {
  Points points(2, disk.outline.cols() + disk.inside.cols());
  points << disk.outline, disk.inside;
  return points;
}

/// The motions from a disk to its image.
class Motions {
 public:
  Motions(const CutDisk& at_rest, const DottedDisk& rest, const DottedDisk& deformed)
      : disk_{at_rest.triangles(), static_cast<int>(rest.outline.cols()), with_points_inside(rest),
              with_points_inside(deformed)},
        at_rest_(disk_.triangles, disk_.rest) {}

  const TriangulatedDisk& disk() const { return disk_; }
  int tries(int search) const {
    const auto vertices = static_cast<int>(disk_.rest.cols());
    const int tries = std::min(kMostTries, kTriesTimesVerticesSquared / (vertices * vertices));
    return search == 0 ? tries : tries / 2;
  }

  Motion straight(ConstructionRandom& random) const {
    Motion motion{Points(2, points()), Points(2, points())};
    for (Eigen::Index i = 0; i < points(); ++i) {
      const Vec2 way = to(i) - from(i);
      motion.detours.col(i) = kFirstDetour * (2 * random.uniform() - 1) * Vec2(way.y(), -way.x());
      motion.times.col(i) << 0, 1;
    }
    return motion;
  }
  /// Another way, another time, or both, for one point.
  Motion changed(Motion motion, ConstructionRandom& random) const {
    const auto i = static_cast<Eigen::Index>(random.uniform() * static_cast<double>(points()));
    const double which = random.uniform();
    if (which < 0.5 + 0.5 * kBothChange) {
      const double departure = (1 - kLeastTime) * random.uniform();
      const double arrival = std::min(1.0, departure + kLeastTime + random.uniform());
      motion.times.col(i) << departure, arrival;
    }
    if (which >= 0.5 - 0.5 * kBothChange) {
      const double x = random.uniform(), y = random.uniform(), part = random.uniform();
      const Vec2 low = disk_.rest.rowwise().minCoeff(), high = disk_.rest.rowwise().maxCoeff();
      const Vec2 anywhere = low + Vec2(x, y).cwiseProduct(high - low);
      motion.detours.col(i) = part * (anywhere - 0.5 * (from(i) + to(i)));
    }
    return motion;
  }
  /// Nothing where the points cannot go so.
  std::optional<CarriedCurves> carried(const Motion& motion) const {
    constexpr double kLongest = 1.0 / kStepsOfAMotion;
    CarriedCurves curves = at_rest_;
    double time = 0, step = kLongest;
    while (time < 1) {
      const double next = std::min(1.0, time + step);
      if (curves.move_to(positions(motion, next))) {
        time = next;
        step = std::min(2 * step, kLongest);
      } else {
        step /= 2;
        if (step < std::ldexp(kLongest, -kMostHalvings)) return std::nullopt;
      }
    }
    return curves;
  }

 private:
  Eigen::Index points() const { return disk_.rest.cols() - disk_.corners; }
  Vec2 from(Eigen::Index point) const { return disk_.rest.col(disk_.corners + point); }
  Vec2 to(Eigen::Index point) const { return disk_.deformed.col(disk_.corners + point); }

  Points positions(const Motion& motion, double time) const {
    if (time == 1) return disk_.deformed;
    Points positions = disk_.rest + time * (disk_.deformed - disk_.rest);
    for (Eigen::Index i = 0; i < points(); ++i) {
      const double departure = motion.times(0, i), arrival = motion.times(1, i);
      const double t = std::clamp((time - departure) / (arrival - departure), 0.0, 1.0);
      positions.col(disk_.corners + i) =
          from(i) + t * (to(i) - from(i)) + 2 * std::min(t, 1 - t) * motion.detours.col(i);
    }
    return positions;
  }

  TriangulatedDisk disk_;
  CarriedCurves at_rest_;
};

/// A motion with the curves that it carries, and what their class costs.
struct CarriedMotion {
  Motion motion;
  std::optional<CarriedCurves> curves;
  double energy = std::numeric_limits<double>::infinity();
};

/// From straight ways on, one change of one point at a time, what costs no more is kept.
CarriedMotion descended(const Motions& motions, const CurveEnergy& energy, int tries,
                        ConstructionRandom& random) {
  const auto carry = [&](Motion motion) {
    CarriedMotion carried;
    carried.curves = motions.carried(motion);
    carried.motion = std::move(motion);
    if (carried.curves) carried.energy = energy(carried.curves->curves());
    return carried;
  };
  CarriedMotion best = carry(motions.straight(random));
  for (int tried = 0; tried < tries; ++tried) {
    CarriedMotion other = carry(motions.changed(best.motion, random));
    if (other.curves && other.energy <= best.energy) best = std::move(other);
  }
  return best;
}

}  // namespace

std::optional<SlitDisks> braided(const DottedDisk& rest, const DottedDisk& deformed, int search) {
  const std::optional<CutDisk> at_rest = CutDisk::over(rest.outline, rest.inside);
  if (!at_rest) return std::nullopt;
  const Motions motions(*at_rest, rest, deformed);
  const CurveEnergy energy(motions.disk());
  CarriedMotion best;
  for (int beginning = 0; beginning < kBeginnings; ++beginning) {
    ConstructionRandom random(static_cast<std::uint64_t>(kBeginnings * search + beginning) + 1);
    CarriedMotion found = descended(motions, energy, motions.tries(search), random);
    if (found.energy < best.energy) best = std::move(found);
  }
  if (!best.curves) return std::nullopt;
  return slit_along(best.curves->curves(), motions.disk());
}

}  // namespace foldless
