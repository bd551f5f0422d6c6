// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/race_setup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "core/energy/densities.h"
#include "core/files/atomic_file.h"
#include "core/mesh/generate.h"
#include "core/scene/scene_io.h"
#include "tests/support/errors.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
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

bool are_all_different(const std::vector<RaceEntry>& entries) {
  std::set<std::string> titles, short_titles;
  for (const RaceEntry& entry : entries) {
    titles.insert(entry.title);
    short_titles.insert(entry.short_title);
  }
  return titles.size() == entries.size() && short_titles.size() == entries.size();
}

TEST(RaceSetup, LanesAreNeverCalledAlike) {
  const Document document = empty_document();
  RaceSetup setup = method_race(document);
  for (std::string& method : setup.methods) method = setup.methods.front();
  EXPECT_TRUE(are_all_different(entries_of(setup, document)));
  EXPECT_TRUE(entries_of(setup, document)[1].short_title.ends_with(" (2)"));
  setup = parameter_race(*find_parameter_row("eta"), document);
  setup.values = {1, 1, 1};
  setup.scenes[2] = {"folder/1.json", {}, document.energy};
  EXPECT_TRUE(are_all_different(entries_of(setup, document)));
}

TEST(RaceSetup, ALaneTakesMethodEnergyAndNumbersFromAScene) {
  const TemporaryFolder folder;
  Scene scene;
  const Shape square = bar(1, 1, 1);
  scene.triangles = square.triangles;
  scene.rest = square.rest;
  scene.energy = &densities()[1];
  scene.parameters.method = "paper-noflip";
  scene.parameters.alpha = 3e6;
  scene.parameters.eta = 0.5;
  save_scene(scene, folder / "stiff knee.json");
  const Document document = empty_document();
  RaceSetup setup = method_race(document);
  setup.scenes[1] = load_race_scene(folder / "stiff knee.json");
  const RaceEntry entry = entries_of(setup, document)[1];
  EXPECT_EQ(entry.title, "stiff knee");
  EXPECT_EQ(entry.short_title, "stiff knee");
  EXPECT_EQ(entry.parameters, scene.parameters);
  EXPECT_EQ(entry.energy, scene.energy);
  EXPECT_EQ(entries_of(setup, document)[0].parameters, document.parameters);
}

TEST(RaceSetup, ALaneThatIsLeftOutTakesItsSceneAlong) {
  const Document document = empty_document();
  RaceSetup setup = method_race(document);
  setup.scenes[setup.lane_count() - 1] = {"a.json", {}, document.energy};
  EXPECT_TRUE(without_lane(setup).scenes.empty());
  setup.scenes.clear();
  setup.scenes[0] = {"a.json", {}, document.energy};
  EXPECT_EQ(without_lane(setup).scenes.size(), 1U);
}

TEST(RaceSetup, AFileThatIsNoSceneIsToldByItsName) {
  const TemporaryFolder folder;
  write_file_atomically(folder / "bad.json", "{\"version\": 1}");
  for (const char* name : {"bad.json", "none.json"}) {
    const std::string problem = error_of([&] { load_race_scene(folder / name); });
    EXPECT_NE(problem.find(name), std::string::npos) << problem;
  }
}

}  // namespace
}  // namespace foldless::test
