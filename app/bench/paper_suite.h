// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/bench/bench_run.h"
#include "app/bench/paper_table.h"
#include "app/bench/text_table.h"

namespace foldless {

/// The reproduction of the paper: its rows as jobs over scenes of our own.
struct PaperSuite {
  std::vector<BenchScene> scenes;  ///< in the order of paper_rows(); the jobs point into it
  std::vector<BenchJob> jobs;
  std::vector<const PaperRow*> rows;  ///< of each job
  std::vector<std::string> left_out;  ///< methods of the paper that the program lacks
};

/// The suite, with the scenes of assets/scenes and those of `methods` alone, or all when it is
/// empty. Throws Error when a scene is missing.
PaperSuite paper_suite(std::span<const std::string> methods);

/// Table 1: what the runs came to beside what the paper reports, where it does.
TextTable table1(const PaperSuite& suite, std::span<const BenchRow> rows);

/// A plot as a file.
struct PlotFile {
  std::string name;
  std::string svg;
};

/// The four plots of Figure 13: E and ‖∇E‖² over the vertex updates, on the coarse and the dense
/// disk, of LIM, without flips, with flips, and with flips without eq. 10. Plots that no run
/// belongs to are left out.
std::vector<PlotFile> figure13(std::span<const BenchRow> rows);

}  // namespace foldless
