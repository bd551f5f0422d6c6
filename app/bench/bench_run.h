// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <stop_token>
#include <string>
#include <vector>

#include "app/bench/bench_scene.h"
#include "core/iteration.h"

namespace foldless {

/// One run of a suite: a scene with parameters of its own, the method among them.
struct BenchJob {
  const BenchScene* scene;  ///< outlives the job
  Parameters parameters;
};

/// How a run followed one frame of a drag.
struct DragFrame {
  double first_seconds = 0;  ///< processor time from the new targets to the first mesh after them
  double seconds = 0;        ///< and to the last mesh of the frame
  int iterations = 0;
  int factorizations = 0;
  double distance = 0;    ///< of the farthest handle from its target at the end [length]
  bool is_valid = false;  ///< of the mesh on show at the end
};

/// What one run came to. Lengths and areas in units of the scene.
struct BenchRow {
  std::size_t job = 0;  ///< its index among the jobs
  std::string scene, difficulty, energy, method;
  Parameters parameters;
  int vertices = 0;  ///< of the scene's mesh
  int faces = 0;
  bool is_satisfied = false;  ///< every handle is at its target: ‖P‖² ≤ 1e-10 D²
  /// Rest and deformed mesh are proved locally injective, exactly, but for boundary vertices.
  bool is_valid = false;
  int overlapping_boundary_vertices = 0;  ///< of the deformed mesh
  std::string outcome;                    ///< a word of report.json, `time-limit`, or `refused`
  std::string note;                       ///< why the method refused the scene; else empty
  Iteration last;                         ///< counters, eq. 7 and 8 of the last record
  double seconds = 0;                     ///< processor time of the run's thread
  double distortion_energy = 0;           ///< E_d of the last state
  double handle_error_squared = 0;        ///< ‖P‖² of the last state
  int vertices_added = 0;                 ///< that splits left in the last state
  double diagonal = 1;                    ///< D of the rest mesh
  double max_conformal_distortion = 1;    ///< not a number where the map is not valid
  double mean_conformal_distortion = 1;   ///< likewise
  std::vector<Iteration> iterations;      ///< every record
  std::vector<DragFrame> frames;          ///< of a drag

  bool has_reached() const { return is_satisfied && is_valid && outcome != "time-limit"; }
  double relative_handle_error() const { return handle_error_squared / (diagonal * diagonal); }
};

/// Runs a method on a scene on the calling thread, to its end or until the token is set, when the
/// outcome is `cancelled`. A method that cannot take the scene, or fails, makes a row that says so.
BenchRow run_job(const BenchJob& job, const std::stop_token& token);

}  // namespace foldless
