// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "app/editor/document.h"

namespace foldless {

/// target_tolerance() of the newest document, found anew only when the mesh or the handles' places
/// on it have changed: it walks over the whole mesh, and is asked for several times a frame.
class TargetTolerance {
 public:
  double of(const Document& document);

 private:
  std::shared_ptr<const Triangles> triangles_;
  std::shared_ptr<const Points> rest_;
  std::vector<int> vertices_;  ///< of the handles
  double value_ = 0;
};

}  // namespace foldless
