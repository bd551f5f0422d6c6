// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/bench_pool.h"

#include <gtest/gtest.h>

#include "core/energy/densities.h"
#include "core/mesh/generate.h"
#include "core/method/methods.h"

namespace foldless {
namespace {

/// A disk with its boundary held and its centre dragged.
BenchScene dragged_disk(const std::string& name, const DiskOptions& options, double offset) {
  BenchScene scene{name, "", {}};
  const Shape shape = disk(options);
  scene.scene.triangles = shape.triangles;
  scene.scene.rest = shape.rest;
  scene.scene.energy = find_density("dirichlet");
  scene.scene.handles.push_back({1, 0, Vec2(offset, 0)});
  for (const int v : disk_ring(options, options.rings))
    scene.scene.handles.push_back({v + 2, v, shape.rest.col(v)});
  return scene;
}

constexpr DiskOptions kSmall{.rings = 4, .boundary_vertices = 24, .vertices = 61};

BenchJob job_of(const BenchScene& scene, const std::string& method) {
  BenchJob job{&scene, scene.scene.parameters};
  job.parameters.method = method;
  return job;
}

TEST(RunJobs, RowsComeInTheOrderOfTheJobsWhateverTheThreads) {
  const BenchScene near = dragged_disk("near", kSmall, 0.2);
  const BenchScene far = dragged_disk("far", kSmall, 0.6);
  std::vector<BenchJob> jobs;
  for (int i = 0; i < 6; ++i)
    for (const BenchScene* scene : {&far, &near}) jobs.push_back(job_of(*scene, "paper-flip"));
  std::vector<std::string> reported;
  const BenchObserver observer{{}, [&](const BenchRow& row) { reported.push_back(row.scene); }};
  const auto one = run_jobs(jobs, {.threads = 1}, {});
  const auto three = run_jobs(jobs, {.threads = 3}, observer);
  ASSERT_EQ(one.size(), jobs.size());
  ASSERT_EQ(three.size(), jobs.size());
  ASSERT_EQ(reported.size(), jobs.size());
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    EXPECT_EQ(three[i].job, i);
    EXPECT_EQ(reported[i], jobs[i].scene->name);
    EXPECT_EQ(three[i].last.factorizations, one[i].last.factorizations);
    EXPECT_EQ(three[i].distortion_energy, one[i].distortion_energy);
    EXPECT_TRUE(three[i].has_reached());
    EXPECT_GT(three[i].seconds, 0);
  }
}

TEST(RunJobs, OfEveryMethodGiveTheSameWhateverTheThreads) {
  const BenchScene scene = dragged_disk("scene", kSmall, 0.4);
  std::vector<BenchJob> jobs;
  for (const MethodRow& method : methods()) jobs.push_back(job_of(scene, std::string(method.name)));
  const auto one = run_jobs(jobs, {.threads = 1}, {});
  const auto many = run_jobs(jobs, {.threads = 4, .team = 2}, {});
  ASSERT_EQ(one.size(), jobs.size());
  ASSERT_EQ(many.size(), jobs.size());
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    SCOPED_TRACE(one[i].method);
    EXPECT_EQ(many[i].method, one[i].method);
    EXPECT_EQ(many[i].outcome, one[i].outcome);
    EXPECT_EQ(many[i].last.factorizations, one[i].last.factorizations);
    EXPECT_EQ(many[i].distortion_energy, one[i].distortion_energy) << "bit for bit";
    EXPECT_EQ(many[i].handle_error_squared, one[i].handle_error_squared);
  }
}

TEST(RunJobs, LosesNoRowWhenWorkersAreFasterThanTheirWatcher) {
  const BenchScene scene =
      dragged_disk("scene", {.rings = 1, .boundary_vertices = 5, .vertices = 6}, 0.1);
  for (int round = 0; round < 200; ++round)
    ASSERT_EQ(run_jobs({job_of(scene, "paper-flip")}, {}, {}).size(), 1u) << "round " << round;
}

TEST(RunJobs, StopsARunThatIsOverItsTime) {
  const BenchScene dense =
      dragged_disk("dense", {.rings = 60, .boundary_vertices = 360, .vertices = 10981}, 0.9);
  const auto rows = run_jobs({job_of(dense, "paper-noflip")}, {.time_limit = 1e-3}, {});
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].outcome, "time-limit");
  EXPECT_FALSE(rows[0].has_reached());
  EXPECT_TRUE(rows[0].is_valid);
}

TEST(RunJobs, AnInterruptEndsWithWhatIsThere) {
  const BenchScene scene = dragged_disk("scene", kSmall, 0.4);
  const std::vector<BenchJob> jobs(5000, job_of(scene, "paper-flip"));
  int reported = 0;
  const auto rows = run_jobs(jobs, {.threads = 2},
                             {.is_interrupted = [&] { return reported > 0; },
                              .finished = [&](const BenchRow&) { ++reported; }});
  EXPECT_GT(rows.size(), 0u);
  EXPECT_LT(rows.size(), jobs.size());
  for (const BenchRow& row : rows) EXPECT_TRUE(row.has_reached());
}

TEST(RunJobs, AMethodThatCannotTakeASceneSaysWhy) {
  const BenchScene scene = dragged_disk("scene", kSmall, 0.4);
  const auto rows = run_jobs({job_of(scene, "no-such-method")}, {}, {});
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].outcome, "refused");
  EXPECT_NE(rows[0].note.find("no-such-method"), std::string::npos);
}

}  // namespace
}  // namespace foldless
