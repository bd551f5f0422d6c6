// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace foldless {

/// Processor seconds of the solving thread, by what they were spent on.
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
  double total() const {
    return analyze + assemble + factorize + solve + line_search + flip + split;
  }
};

/// Processor time of the calling thread. [s]
double thread_seconds();

/// Adds the processor time of its own life to a stage.
class StageTimer {
 public:
  explicit StageTimer(double& stage) : stage_(stage), start_(thread_seconds()) {}
  ~StageTimer() { stage_ += thread_seconds() - start_; }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  double& stage_;
  double start_;
};

}  // namespace foldless
