// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/approach_refined.h"

#include <utility>

#include "core/method/foldless/approach.h"
#include "core/method/foldless/legs.h"

namespace foldless {
namespace refined_approach {

constexpr int kLargestMesh = 2000;  ///< [triangles]

}  // namespace refined_approach

Steps<Progress> approach_refined(Workspace& work, MeshPair start) {
  if (start.face_count() > refined_approach::kLargestMesh) co_return Progress::locked;
  Workspace other = work;
  other.set_mesh(std::move(start));
  other.refine();
  ++work.system.effort().rounds;
  const Progress progress = co_await approach(other, FactorUse::lagged, legs_of(other));
  if (progress == Progress::arrived) work = std::move(other);
  co_return progress;
}

}  // namespace foldless
