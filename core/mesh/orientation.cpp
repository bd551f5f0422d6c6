// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/orientation.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace foldless {

int exact_orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  if (!a.allFinite() || !b.allFinite() || !c.allFinite()) return 0;
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto point = [](const Vec2& p) { return Kernel::Point_2(p.x(), p.y()); };
  return static_cast<int>(Kernel().orientation_2_object()(point(a), point(b), point(c)));
}

}  // namespace foldless
