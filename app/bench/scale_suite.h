// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "app/bench/bench_run.h"
#include "app/bench/text_table.h"

namespace foldless {

/// How the time of a method grows with the mesh: a bar that is bent and a disk that is twisted, at
/// about 2,000, 20,000, 100,000 and 400,000 triangles, and a mild bend of a bar of a million.
/// Smallest first within each kind.
std::vector<BenchScene> scale_suite();

/// Seconds and factorizations by size, and the exponent p of seconds ~ F^p between a size and the
/// one before it under the same method. `rows` in the order of the suite.
TextTable scale_table(std::span<const BenchRow> rows);

}  // namespace foldless
