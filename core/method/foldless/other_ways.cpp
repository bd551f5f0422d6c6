// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/other_ways.h"

#include <utility>
#include <vector>

#include "core/method/foldless/transport_plans.h"

namespace foldless {
namespace {

/// Handles of a mesh of at most so many triangles are carried in many orders; all of it takes
/// seconds then.
constexpr int kLargestInManyOrders = 5000;
constexpr int kRandomOrders = 16;
/// One of so many is refined when nothing else helped.
constexpr int kLargestRefined = 2000;
/// The mesh as it is, then refined.
constexpr int kMostGoingOn = 2;

}  // namespace

OtherWays::OtherWays(const EnergySettings& energy, bool approach_first)
    : energy_(energy), is_approach_next_(approach_first) {}

std::optional<Attempt> OtherWays::next(const Workspace& at_rest) {
  ++count_;
  if (std::exchange(is_approach_next_, false)) return Attempt::approach(at_rest);
  const Points& targets = at_rest.positions.targets;
  const Points starts = held_where_they_are(at_rest.positions, at_rest.mesh.deformed()).targets;
  const int faces = at_rest.mesh.face_count();
  const std::size_t first = transport_plans(starts, targets, 0).size();
  if (transports_ == first && nearest_ && going_on_ < kMostGoingOn) return going_on(at_rest);
  const std::vector<TransportPlan> plans =
      transport_plans(starts, targets, faces <= kLargestInManyOrders ? kRandomOrders : 0);
  const std::size_t next = transports_++;
  const bool is_refined = next >= plans.size();
  if (next >= 2 * plans.size() || (is_refined && faces > kLargestRefined)) return std::nullopt;
  Workspace work = at_rest;
  if (is_refined) work.refine();
  return Attempt::transport(std::move(work), energy_, plans[next % plans.size()], next >= first);
}

Attempt OtherWays::going_on(const Workspace& at_rest) {
  Workspace work = *nearest_;
  work.take_counts(at_rest);
  if (going_on_++ > 0) work.refine();
  return Attempt::going_on(std::move(work), energy_);
}

void OtherWays::take_locked(const Workspace& transport) {
  if (!nearest_ || transport.error() < nearest_->error()) nearest_ = transport;
}

}  // namespace foldless
