// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "app/bench/bench_run.h"
#include "app/bench/text_table.h"

namespace foldless {

/// How the time of a method grows with the mesh. Scenes 0 to 3: a bar that is bent, of about 2,000,
/// 20,000, 100,000 and 400,000 triangles; 4 to 7: a disk that is twisted, of the same sizes; 8: a
/// mild bend of a bar of a million; 9 and 10: a strong one and a twist of a million; 11: a mild
/// bend of two million.
inline constexpr int kScaleScenes = 12;
BenchScene scale_scene(int index);

/// Seconds and factorizations by size, and the exponent p of seconds ~ F^p between a size and the
/// one before it under the same method. `rows` in the order of the suite.
TextTable scale_table(std::span<const BenchRow> rows);

}  // namespace foldless
