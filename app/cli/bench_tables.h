// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "app/bench/bench_run.h"
#include "app/bench/paper_suite.h"

namespace foldless {

// What `bench -o DIR` writes: the tables of one call together, in the place of those of an earlier
// one. All throw Error; then the earlier ones are whole.

/// Every method on every scene.
void write_comparison(const std::filesystem::path& folder, const std::vector<BenchRow>& rows);
/// Table 1 and Figure 13.
void write_paper(const std::filesystem::path& folder, const PaperSuite& suite,
                 const std::vector<BenchRow>& rows);
void write_scale(const std::filesystem::path& folder, const std::vector<BenchRow>& rows);
void write_drags(const std::filesystem::path& folder, const std::vector<BenchRow>& rows);

}  // namespace foldless
