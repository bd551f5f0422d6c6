// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/bench/bench_run.h"
#include "app/bench/text_table.h"
#include "core/scene/json_node.h"

namespace foldless {

/// Every run of a suite, one a row, for reading.
TextTable rows_table(std::span<const BenchRow> rows);
/// The same with all digits, and with every number of the rows, for other programs.
TextTable rows_csv_table(std::span<const BenchRow> rows);
JsonNode rows_node(std::span<const BenchRow> rows);

/// What one method came to over a suite.
struct MethodSummary {
  std::string method;
  int runs = 0;
  int reached = 0;
  int invalid = 0;  ///< runs whose last mesh is not locally injective
  long factorizations = 0;
  long updates = 0;
  double seconds = 0;
  double median_seconds = 0;
  /// Over the scenes that this and the first method reach: how many they are, and the geometric
  /// means of this method's factorizations and seconds over the first one's.
  int shared = 0;
  double factorization_ratio = 1;
  double seconds_ratio = 1;
  /// Of the scenes that it reaches, those with an E_d of at most 1.02 times the least that any run
  /// reached them with, and the largest ratio to that.
  int near_best = 0;
  double largest_energy_ratio = 1;
};

/// One summary a method, in the order in which the rows name them.
std::vector<MethodSummary> summaries_of(std::span<const BenchRow> rows);
TextTable summary_table(std::span<const MethodSummary> summaries);
/// Scenes that each method reaches of each difficulty, `7/10`. Empty for rows without difficulty.
TextTable difficulty_table(std::span<const BenchRow> rows);

}  // namespace foldless
