// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/bench_report.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace foldless {
namespace {

BenchRow row_of(const std::string& scene, const std::string& method, int factorizations,
                bool reached) {
  BenchRow row;
  row.scene = scene;
  row.difficulty = "easy";
  row.energy = "arap";
  row.method = method;
  row.outcome = "gradient";
  row.is_satisfied = reached;
  row.is_valid = true;
  row.last.factorizations = factorizations;
  row.seconds = 0.01 * factorizations;
  return row;
}

std::vector<BenchRow> two_methods() {
  return {row_of("a", "first", 10, true),  row_of("a", "second", 20, true),
          row_of("b", "first", 10, true),  row_of("b", "second", 80, true),
          row_of("c", "first", 10, false), row_of("c", "second", 1, true),
          row_of("d", "first", 10, true),  row_of("d", "second", 7, false)};
}

TEST(Summaries, CountWhatIsReached) {
  const auto summaries = summaries_of(two_methods());
  ASSERT_EQ(summaries.size(), 2u);
  EXPECT_EQ(summaries[0].reached, 3);
  EXPECT_EQ(summaries[1].reached, 3);
  EXPECT_EQ(summaries[1].runs, 4);
  EXPECT_EQ(summaries[1].factorizations, 108);
}

TEST(Summaries, RatiosAreGeometricMeansOverScenesThatBothReach) {
  const auto summaries = summaries_of(two_methods());
  EXPECT_EQ(summaries[1].shared, 2);
  EXPECT_DOUBLE_EQ(summaries[1].factorization_ratio, 4);  // of 2 and 8
  EXPECT_DOUBLE_EQ(summaries[1].seconds_ratio, 4);
  EXPECT_DOUBLE_EQ(summaries[0].factorization_ratio, 1);
}

TEST(Summaries, WhatIsFoldedOrTooLateIsNotReached) {
  BenchRow folded = row_of("a", "first", 1, true);
  folded.is_valid = false;
  BenchRow late = row_of("b", "first", 1, true);
  late.outcome = "time-limit";
  const auto summaries = summaries_of(std::vector{folded, late});
  EXPECT_EQ(summaries[0].reached, 0);
  EXPECT_EQ(summaries[0].invalid, 1);
}

TEST(RowsTable, TellsOtherProgramsHowManyBoundaryVerticesOverlap) {
  BenchRow row = row_of("a", "first", 1, true);
  row.overlapping_boundary_vertices = 3;
  const std::string csv = rows_csv_table(std::vector{row}).csv();
  EXPECT_NE(csv.find(",overlapping_boundary_vertices,note,E_d_ratio_to_best\n"), std::string::npos)
      << csv;
  EXPECT_NE(csv.find(",3,,"), std::string::npos) << csv;
  const JsonNode rows = rows_node(std::vector{row});
  const auto& object = *rows.as<JsonNode::Array>()->front().as<JsonNode::Object>();
  const auto field =
      std::ranges::find(object, "overlapping_boundary_vertices", &JsonNode::Member::key);
  ASSERT_NE(field, object.end());
  EXPECT_EQ(*field->value.as<double>(), 3);
}

TEST(BestEnergies, AreTheLeastOfAnyRunThatReachesTheScene) {
  std::vector<BenchRow> rows = two_methods();
  const double energies[] = {3, 2, 5, 5.05, 1, 4, 7, 6};
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].distortion_energy = energies[i];
  const std::string csv = rows_csv_table(rows).csv();
  EXPECT_NE(csv.find(",1.5\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",1.01\n"), std::string::npos) << csv;
  const auto summaries = summaries_of(rows);
  EXPECT_EQ(summaries[0].near_best, 2) << "of b and d; the better run of d did not arrive";
  EXPECT_EQ(summaries[1].near_best, 3);
  EXPECT_DOUBLE_EQ(summaries[0].largest_energy_ratio, 1.5);
  EXPECT_DOUBLE_EQ(summaries[1].largest_energy_ratio, 1.01);
}

TEST(BestEnergies, AMapThatLiesOverItselfAtTheBoundaryDoesNotCount) {
  std::vector<BenchRow> rows = two_methods();
  const double energies[] = {3, 2, 5, 5.05, 1, 4, 7, 6};
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].distortion_energy = energies[i];
  rows[1].overlapping_boundary_vertices = 1;  // the better run of a
  const auto summaries = summaries_of(rows);
  EXPECT_DOUBLE_EQ(summaries[0].largest_energy_ratio, 1) << "1.5 with it";
  EXPECT_EQ(summaries[1].near_best, 2) << "3 with it";
}

TEST(BestEnergies, ARunThatArrivedNowhereHasNoRatio) {
  BenchRow missed = row_of("a", "first", 1, false);
  missed.distortion_energy = 2;
  const JsonNode rows = rows_node(std::vector{missed});
  const auto& object = *rows.as<JsonNode::Array>()->front().as<JsonNode::Object>();
  const auto field = std::ranges::find(object, "E_d_ratio_to_best", &JsonNode::Member::key);
  ASSERT_NE(field, object.end());
  EXPECT_EQ(field->value.as<double>(), nullptr);
}

TEST(DifficultyTable, CountsByDifficultyAndMethod) {
  EXPECT_EQ(difficulty_table(two_methods()).csv(), "reached,first,second\neasy,3/4,3/4\n");
}

}  // namespace
}  // namespace foldless
