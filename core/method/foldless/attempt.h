// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>

#include "core/method/foldless/approach.h"
#include "core/method/foldless/settle.h"
#include "core/method/foldless/transport.h"

namespace foldless {

/// Another way to the targets, on a mesh of its own: an approach or a transport. A persistent
/// transport that locks settles under the energy of the scene with the handles held where they
/// are, which gives triangles that it left as slivers their shape back, and carries the handles on
/// from there; again, while every such round brings them a good deal nearer.
class Attempt {
 public:
  static Attempt approach(Workspace workspace);
  /// `energy` is that of the scene.
  static Attempt transport(Workspace workspace, const EnergySettings& energy, TransportPlan plan,
                           bool is_persistent);
  /// A persistent transport that begins with its first round, where another one locked.
  static Attempt going_on(Workspace locked, const EnergySettings& energy);

  Progress step(std::stop_token token, VertexUpdate& update);
  bool is_transport() const { return !std::holds_alternative<Approach>(way_); }
  /// Goes on as an approach under the energy of the scene, from the mesh as it is.
  void begin_approach();

  Workspace work;

 private:
  using Way = std::variant<Approach, Transport, Settle>;

  Attempt(Workspace workspace, Way way, const EnergySettings& energy, int most_rounds);
  bool may_go_on() const;
  void begin_round();
  void carry_on();

  EnergySettings energy_;
  Way way_;
  int rounds_ = 0;
  int most_rounds_;
  double locked_error_;  ///< ‖P‖² when it locked last
};

}  // namespace foldless
