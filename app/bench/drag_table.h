// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "app/bench/bench_run.h"
#include "app/bench/text_table.h"
#include "core/scene/json_node.h"

namespace foldless {

/// How one run followed its drag, over its frames.
struct DragSummary {
  double median_first_seconds = 0;  ///< from new targets to the first mesh
  double p95_first_seconds = 0;
  double median_seconds = 0;  ///< and to the last mesh of the frame
  double p95_seconds = 0;
  double p95_distance = 0;    ///< of the farthest handle from its target at the end of a frame [D]
  double factorizations = 0;  ///< a frame, mean
  double iterations = 0;      ///< a frame, mean
  int invalid = 0;            ///< frames that end with a folded mesh
};

/// Of a run without frames, all zero.
DragSummary drag_summary(const BenchRow& row);

/// The value that a part `p` of the values, 0 to 1, do not exceed; 0 where there are none.
double percentile(std::vector<double> values, double p);

/// One drag and method a row, for reading: times in milliseconds.
TextTable drag_table(std::span<const BenchRow> rows);
/// The same with all digits, times in seconds, for other programs.
TextTable drag_csv_table(std::span<const BenchRow> rows);
JsonNode drag_node(std::span<const BenchRow> rows);
/// Every frame of every run, one a row.
TextTable drag_frames_table(std::span<const BenchRow> rows);

}  // namespace foldless
