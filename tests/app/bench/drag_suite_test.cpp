// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/drag_suite.h"

#include <gtest/gtest.h>

#include "app/bench/bench_run.h"
#include "app/bench/drag_table.h"
#include "core/method/satisfied.h"

namespace foldless {
namespace {

TEST(DragSuite, OneHandleMovesByAHundredthOfTheDiagonalAFrameAndTurnsBack) {
  for (int i = 0; i < kDragScenes; ++i) {
    const BenchScene drag = drag_scene(i);
    SCOPED_TRACE(drag.name);
    const double stride = 0.01 * bounding_box_diagonal(drag.scene.rest);
    const Eigen::Index last = drag.targets[0].cols() - 1;
    EXPECT_GE(drag.targets.size(), 100u);
    int reversals = 0;
    Vec2 before = drag.scene.handles.back().target, step_before(0, 0);
    for (const Points& targets : drag.targets) {
      const Vec2 step = targets.col(last) - before;
      EXPECT_NEAR(step.norm(), stride, 1e-3 * stride);
      reversals += step.dot(step_before) < 0 ? 1 : 0;
      EXPECT_EQ(targets.leftCols(last), drag.targets[0].leftCols(last));
      before = targets.col(last);
      step_before = step;
    }
    EXPECT_GE(reversals, 2);
  }
}

TEST(DragSuite, IsMeasuredFrameByFrame) {
  const BenchScene drag = drag_scene(0);
  BenchJob job{&drag, drag.scene.parameters};
  job.parameters.method = "foldless";
  const BenchRow row = run_job(job, {});
  ASSERT_EQ(row.frames.size(), drag.targets.size());
  EXPECT_TRUE(row.is_valid);
  const DragSummary summary = drag_summary(row);
  EXPECT_LE(summary.p95_distance, 1e-6);
  EXPECT_EQ(summary.invalid, 0);
  EXPECT_GT(summary.factorizations, 0);
  EXPECT_LT(summary.factorizations, 0.5) << "a factor serves several frames";
  EXPECT_LE(summary.iterations, 2);
  for (const DragFrame& frame : row.frames) EXPECT_GE(frame.seconds, frame.first_seconds);
}

TEST(DragSuite, AStoppedRunHasTheFramesThatItMade) {
  const BenchScene drag = drag_scene(0);
  std::stop_source stopped;
  stopped.request_stop();
  const BenchRow row = run_job({&drag, {}}, stopped.get_token());
  EXPECT_TRUE(row.frames.empty());
  EXPECT_EQ(drag_summary(row).p95_seconds, 0);
}

TEST(Percentile, IsTheValueThatThisPartDoesNotExceed) {
  EXPECT_EQ(percentile({}, 0.95), 0);
  EXPECT_EQ(percentile({3}, 0.95), 3);
  EXPECT_EQ(percentile({4, 1, 3, 2}, 0.5), 2);
  std::vector<double> values;
  for (int i = 1; i <= 100; ++i) values.push_back(i);
  EXPECT_EQ(percentile(values, 0.95), 95);
}

}  // namespace
}  // namespace foldless
