// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/paper_suite.h"

#include <gtest/gtest.h>

#include <map>

#include "core/method/methods.h"

namespace foldless {
namespace {

TEST(PaperSuite, ItsScenesHaveTheSizesAndEnergiesOfTable1) {
  const std::map<std::string, std::tuple<int, int, std::string>> table{
      {"figure5_coarse_disk", {293, 542, "lscm"}},
      {"figure6_dense_disk", {2483, 4844, "dirichlet"}},
      {"figure10_alligator", {928, 1236, "green-strain"}},
      {"figure10_cowboy", {200, 333, "arap"}},
      {"figure11_dense_grid", {121, 200, "lscm"}},
      {"figure11_coarse_grid", {36, 50, "arap"}}};
  std::size_t found = 0;
  for (const auto& [name, difficulty, scene, targets] : paper_suite({}).scenes) {
    const auto row = table.find(name);
    if (row == table.end()) continue;
    ++found;
    EXPECT_EQ(row->second, std::tuple(static_cast<int>(scene.rest.cols()),
                                      static_cast<int>(scene.triangles.cols()),
                                      std::string(scene.energy->name)));
  }
  EXPECT_EQ(found, table.size());
}

TEST(PaperSuite, HasAJobForEveryRowWhoseMethodThereIs) {
  const PaperSuite suite = paper_suite({});
  std::size_t missing = 0;
  for (const PaperRow& row : paper_rows()) missing += find_method(row.method) == nullptr ? 1 : 0;
  ASSERT_EQ(suite.jobs.size(), paper_rows().size() - missing);
  ASSERT_EQ(suite.rows.size(), suite.jobs.size());
  for (std::size_t i = 0; i < suite.jobs.size(); ++i) {
    EXPECT_EQ(suite.jobs[i].scene->name, suite.rows[i]->scene);
    EXPECT_EQ(suite.jobs[i].parameters.method, suite.rows[i]->method);
    EXPECT_EQ(suite.jobs[i].parameters.delta, suite.rows[i]->delta);
    EXPECT_EQ(suite.jobs[i].parameters.condition_test, suite.rows[i]->condition_test);
  }
  for (const std::string& method : suite.left_out) EXPECT_EQ(find_method(method), nullptr);
}

TEST(PaperSuite, TakesTheMethodsThatAreWantedAlone) {
  const std::vector<std::string> wanted{"paper-noflip"};
  const PaperSuite suite = paper_suite(wanted);
  EXPECT_EQ(suite.jobs.size(), 6u);
  EXPECT_TRUE(suite.left_out.empty());
}

TEST(PaperSuite, Table1SetsOurFiguresBesideThePapers) {
  const std::vector<std::string> wanted{"paper-noflip"};
  const PaperSuite suite = paper_suite(wanted);
  BenchRow row;
  row.job = 0;
  row.scene = suite.scenes[0].name;
  row.is_valid = true;
  row.outcome = "step";
  row.last.factorizations = 12;
  row.last.updates = 5;
  const std::string text = table1(suite, std::vector{row}).csv();
  EXPECT_NE(text.find(",S,12/5,"), std::string::npos) << text;
  EXPECT_EQ(text.find("folded"), std::string::npos) << text;
  row.is_valid = false;
  EXPECT_NE(table1(suite, std::vector{row}).csv().find(",folded,"), std::string::npos);
  EXPECT_NE(text.find(",81.4/8.40,3.9e-14,G,187/77,0.41"), std::string::npos) << text;
}

TEST(Figure13, HasACurveForEachMethodThatRan) {
  std::vector<BenchRow> rows;
  for (const std::string method : {"lim", "paper-noflip", "paper-flip", "paper-flip"}) {
    BenchRow& row = rows.emplace_back();
    row.scene = "figure5_coarse_disk";
    row.method = method;
    row.iterations.resize(3);
    for (Iteration& record : row.iterations) record.energy = record.gradient_norm_squared = 1;
  }
  rows.back().parameters.condition_test = false;
  const auto files = figure13(rows);
  ASSERT_EQ(files.size(), 2u) << "nothing ran on the dense disk";
  EXPECT_EQ(files[0].name, "figure13_coarse_disk_energy.svg");
  for (const PlotFile& file : files)
    for (const char* colour : {"#d62728", "#2ca02c", "#1f77b4", "#222222\" stroke-width=\"1.6"})
      EXPECT_NE(file.svg.find(colour), std::string::npos) << file.name << " lacks " << colour;
}

}  // namespace
}  // namespace foldless
