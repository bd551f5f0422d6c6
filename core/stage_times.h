// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace foldless {

/// Seconds of the solving thread, by what they were spent on.
struct StageTimes {
  double analyze = 0;      ///< ordering and symbolic factorization
  double assemble = 0;     ///< gradients and Hessians
  double factorize = 0;    ///< numeric factorization, failed attempts too
  double solve = 0;        ///< triangular solves
  double line_search = 0;  ///< step bounds and energies along the line
  double flip = 0;         ///< FlipEdges
  double split = 0;        ///< SplitEdges

  StageTimes& operator+=(const StageTimes& other) {
    analyze += other.analyze;
    assemble += other.assemble;
    factorize += other.factorize;
    solve += other.solve;
    line_search += other.line_search;
    flip += other.flip;
    split += other.split;
    return *this;
  }
  friend StageTimes operator*(double factor, StageTimes times) {
    for (double* stage : {&times.analyze, &times.assemble, &times.factorize, &times.solve,
                          &times.line_search, &times.flip, &times.split})
      *stage *= factor;
    return times;
  }
  double total() const {
    return analyze + assemble + factorize + solve + line_search + flip + split;
  }
};

/// Processor time of the calling thread. [s]
double thread_seconds();

/// Adds the seconds of its own life to a stage, by the clock on the wall: the thread's own is a
/// call of the system that takes microseconds, a dozen of which a frame of a small mesh would
/// notice.
class StageTimer {
 public:
  explicit StageTimer(double& stage) : stage_(stage), start_(Clock::now()) {}
  ~StageTimer() { stage_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  double& stage_;
  Clock::time_point start_;
};

}  // namespace foldless
