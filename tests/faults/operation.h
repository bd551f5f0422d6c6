// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace foldless::test {

/// How the program ended in which one call failed.
struct Faulted {
  bool has_happened = false;  ///< there were enough calls of that kind
  int status = -1;            ///< negative: the signal that ended it
  std::string err;
};

/// Runs the program; `fault` as tests/faults/preload.cpp has it, in files below `folder`; empty:
/// none.
Faulted run_with_fault(const std::vector<std::string>& arguments, const std::string& fault,
                       const std::filesystem::path& folder);

/// The same of another program, where the faults count from its first call of signal() on.
Faulted run_other_with_fault(const std::string& program, const std::vector<std::string>& arguments,
                             const std::string& fault, const std::filesystem::path& folder);

/// Whether FOLDLESS_FAULTS asks for every fault: `places`, but of the allocations that the same
/// calls lead to the first only; `all`, those too, which takes hours.
bool wants_all_faults();
/// The fault of the n-th allocation, or place.
std::string memory_fault(long n);
/// The n after it of faults of which there are many: by default a quarter more.
long next_of_many(long n);

/// Counts the faults of a test by their kinds, and tells them in the log at its end.
class FaultCounts {
 public:
  FaultCounts() = default;
  FaultCounts(const FaultCounts&) = delete;
  FaultCounts& operator=(const FaultCounts&) = delete;
  ~FaultCounts();
  void failed(const std::string& kind) { ++counts_[kind].failed; }
  void last(const std::string& kind) { ++counts_[kind].last; }
  int all_failed() const;
  int all_last() const;
  bool has_failed(const std::string& kind) const { return count_of(kind).failed > 0; }
  bool has_been_last(const std::string& kind) const { return count_of(kind).last > 0; }

 private:
  struct Count {
    int failed = 0;  ///< calls that failed
    int last = 0;    ///< calls before which the program was killed
  };
  Count count_of(const std::string& kind) const {
    const auto at = counts_.find(kind);
    return at == counts_.end() ? Count{} : at->second;
  }

  std::map<std::string, Count> counts_;
};

/// Runs the program and kills it after a time, if it lives so long.
void run_and_kill(const std::vector<std::string>& arguments, std::chrono::microseconds time);

/// The bytes of all files below a folder, by their paths in it.
using Files = std::map<std::string, std::string>;
Files files_in(const std::filesystem::path& folder);
void write_files(const std::filesystem::path& folder, const Files& files);

}  // namespace foldless::test
