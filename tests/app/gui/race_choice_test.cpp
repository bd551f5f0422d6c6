// SPDX-License-Identifier: GPL-3.0-or-later
// What the lanes of a race are, chosen with the mouse: the whole editor off screen.
#include <gtest/gtest.h>

#include <string>

#include "core/energy/densities.h"
#include "core/scene/scene_io.h"
#include "tests/app/gui/bent_bar.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

class RaceChoice : public testing::Test {
 protected:
  RaceChoice() {
    EXPECT_TRUE(bend_a_bar(headless_));
    headless_.key(Key::m);
    EXPECT_TRUE(headless_.wait_until([this] { return race().is_finished(); }));
    headless_.settle();
  }

  Race& race() { return headless_.editor().race(); }
  void click_words(const std::string& words) {
    const auto place = headless_.find_words(words);
    ASSERT_TRUE(place) << words;
    headless_.click(*place);
    headless_.move({2, 2});  // no tooltip over what is clicked next
    headless_.settle();
  }
  void type_path(const std::filesystem::path& path) {
    for (const char c : path.string())
      headless_.ui().receive(CharacterTyped{static_cast<char32_t>(c)});
    headless_.settle();
    headless_.key(Key::enter);
    headless_.settle();
  }

  HeadlessEditor headless_{{1600, 800}};
};

TEST_F(RaceChoice, ALaneTakesASceneAndABadFileLeavesItAsItIs) {
  const TemporaryFolder folder;
  Scene scene;
  const Shape square = bar(1, 1, 1);
  scene.triangles = square.triangles;
  scene.rest = square.rest;
  scene.energy = &densities()[1];
  scene.parameters.method = "paper-noflip";
  scene.parameters.eta = 0.5;
  save_scene(scene, folder / "stiff.json");
  const Document before = headless_.editor().document();

  click_words(race().lanes()[1]->title());
  click_words("From a scene…");
  type_path(folder / "stiff.json");
  ASSERT_EQ(race().setup().scenes.count(1), 1U);
  EXPECT_TRUE(headless_.wait_until([this] { return race().is_finished(); }));
  headless_.settle();
  EXPECT_EQ(race().lanes()[1]->title(), "stiff");
  EXPECT_EQ(race().lanes()[1]->parameters(), scene.parameters);
  EXPECT_EQ(&race().lanes()[1]->energy(), scene.energy);
  EXPECT_EQ(race().lanes()[1]->shown()->handles.size(), before.handles.size());
  EXPECT_TRUE(headless_.find_words("stiff"));

  const RaceSetup chosen = race().setup();
  click_words(race().lanes()[0]->title());
  click_words("From a scene…");
  type_path(folder.write("bad.json", "{}"));
  EXPECT_EQ(race().setup(), chosen);
  ASSERT_FALSE(headless_.editor().messages().toasts().empty());
  EXPECT_NE(headless_.editor().messages().toasts().back().text.find("bad.json"), std::string::npos);
}

TEST_F(RaceChoice, AMethodTakesTheSceneOutAgain) {
  RaceSetup setup = race().setup();
  setup.scenes[1] = {"stiff.json", headless_.editor().document().parameters,
                     headless_.editor().document().energy};
  race().set_setup(setup);
  ASSERT_TRUE(headless_.wait_until([this] { return race().is_finished(); }));
  headless_.settle();
  click_words("stiff");
  click_words("Locally injective mappings");
  EXPECT_TRUE(race().setup().scenes.empty());
}

TEST_F(RaceChoice, AValueAndASceneRaceEachOther) {
  race().set_setup(parameter_race(*find_parameter_row("eta"), race().document()));
  RaceSetup setup = race().setup();
  setup.scenes[2] = {"stiff.json", headless_.editor().document().parameters,
                     headless_.editor().document().energy};
  race().set_setup(setup);
  ASSERT_TRUE(headless_.wait_until([this] { return race().is_finished(); }));
  headless_.settle();
  EXPECT_EQ(race().lanes()[0]->title(), "η = 0.001");
  click_words("stiff");
  click_words("A value of " + std::string(race().setup().varied->title));
  EXPECT_TRUE(race().setup().scenes.empty());
}

}  // namespace
}  // namespace foldless::test
