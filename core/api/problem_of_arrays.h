// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <foldless/solve.h>

#include <vector>

#include "core/method/method.h"
#include "core/run/run.h"

namespace foldless {

/// What a caller of the library asks to be solved; throws Error as solve() says.
Problem problem_of_arrays(const PointsRef& rest, const TrianglesRef& triangles,
                          const std::vector<int>& handles, const PointsRef& targets,
                          const SolveOptions& options);

/// Starts the method that the options ask for. Whichever it is, what Run publishes is held to what
/// the method `foldless` promises.
MethodStarter starter_for(const SolveOptions& options);

}  // namespace foldless
