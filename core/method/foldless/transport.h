// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/method/foldless/handle_paths.h"
#include "core/method/foldless/workspace.h"

namespace foldless {

/// One way of carrying the handles to their targets.
struct TransportPlan {
  PathKind path = PathKind::straight;
  /// Groups of handles that travel together, one group after the other.
  std::vector<std::vector<int>> groups;
  double stride = 0.05;  ///< how far a handle is moved at a time [D]
};

/// The stage for handles that the approach could not bring home. It forgets the distortion of the
/// map for a while: from the rest state, handles are carried along paths in short strides under the
/// symmetric Dirichlet energy of each deformed triangle against an equilateral one, flips serving
/// that energy. Where a handle lags, edges ahead of it are split. Arrives when the handles are
/// exactly on their targets.
class Transport {
 public:
  /// The energy that `workspace` must have.
  static EnergySettings energy(double delta);

  Transport(Workspace& workspace, TransportPlan plan);
  Progress step(Workspace& workspace, std::stop_token token, VertexUpdate& update);

 private:
  void begin_stride(Workspace& workspace);
  Progress end_stride(Workspace& workspace);
  double distance_to_go(const Workspace& workspace, int handle) const;
  void split_ahead(Workspace& workspace);

  TransportPlan plan_;
  HandlePaths paths_;
  std::vector<double> lambda_;  ///< by handle: where on its path the stride ends
  Positions aimed_;             ///< targets of this stride
  std::size_t group_ = 0;
  double lag_ = 0;  ///< Σ of the distances to go when the stride began
  int steps_of_stride_ = 0;
  int strides_without_gain_ = 0;
};

}  // namespace foldless
