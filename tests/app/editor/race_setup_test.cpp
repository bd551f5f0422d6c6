// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/race_setup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/energy/densities.h"

namespace foldless {
namespace {

TEST(RaceSetup, VariesAParameterInStepsOfTen) {
  const Document document = empty_document();
  const RaceSetup setup = parameter_race(*find_parameter_row("eta"), document);
  ASSERT_EQ(setup.values.size(), 3U);
  EXPECT_DOUBLE_EQ(setup.values[0], 1e-3);
  EXPECT_DOUBLE_EQ(setup.values[1], 1e-2);
  EXPECT_DOUBLE_EQ(setup.values[2], 1e-1);
  const auto entries = entries_of(setup, document);
  ASSERT_EQ(entries.size(), 3U);
  EXPECT_EQ(entries[1].title, "η = 0.01");
  EXPECT_DOUBLE_EQ(entries[1].parameters.eta, 1e-2);
  EXPECT_EQ(entries[1].parameters.method, document.parameters.method);
}

TEST(RaceSetup, EveryParameterMakesLanesWithinItsRange) {
  const Document document = empty_document();
  for (const ParameterRow& row : parameter_rows()) {
    RaceSetup setup = parameter_race(row, document);
    for (int i = 0; i < 3; ++i) setup = with_lane(setup);
    EXPECT_EQ(setup.lane_count(), kMostLanes) << row.name;
    for (const double value : setup.values) {
      EXPECT_GE(value, row.minimum) << row.name;
      EXPECT_LE(value, row.maximum) << row.name;
    }
    for (int i = 0; i < 4; ++i) setup = without_lane(setup);
    EXPECT_EQ(setup.lane_count(), kFewestLanes) << row.name;
  }
}

TEST(RaceSetup, MethodsDifferAsLongAsThereAreEnough) {
  const Document document = empty_document();
  const RaceSetup setup = method_race(document);
  EXPECT_EQ(setup.methods.front(), document.parameters.method);
  EXPECT_EQ(std::ranges::count(setup.methods, setup.methods.back()), 1);
}

TEST(RaceSetup, EnergiesDifferAndBeginWithTheDocuments) {
  Document document = empty_document();
  document.energy = &densities()[1];
  RaceSetup setup = energy_race(document);
  ASSERT_EQ(setup.lane_count(), kMostLanes);
  EXPECT_EQ(setup.energies.front(), document.energy);
  EXPECT_EQ(std::set(setup.energies.begin(), setup.energies.end()).size(), kMostLanes);
  const auto entries = entries_of(setup, document);
  ASSERT_EQ(entries.size(), kMostLanes);
  for (std::size_t i = 0; i < kMostLanes; ++i) {
    EXPECT_EQ(entries[i].energy, setup.energies[i]);
    EXPECT_EQ(entries[i].title, setup.energies[i]->title);
    EXPECT_EQ(entries[i].parameters.method, document.parameters.method);
  }
  for (int i = 0; i < 4; ++i) setup = without_lane(setup);
  EXPECT_EQ(setup.lane_count(), kFewestLanes);
  EXPECT_EQ(with_lane(setup).energies.size(), kFewestLanes + 1);
}

TEST(RaceSetup, ASwitchHasWords) {
  const Document document = empty_document();
  const RaceSetup setup = parameter_race(*find_parameter_row("condition_test"), document);
  const auto entries = entries_of(setup, document);
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_EQ(entries[0].title, "Condition test: on");
  EXPECT_EQ(entries[1].title, "Condition test: off");
  EXPECT_FALSE(entries[1].parameters.condition_test);
}

}  // namespace
}  // namespace foldless
