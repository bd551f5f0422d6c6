// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/race.h"

#include <algorithm>
#include <sstream>

#include "app/editor/race_table.h"
#include "core/method/methods.h"
#include "tests/app/editor/editor_fixture.h"

namespace foldless::test {
namespace {

/// A grid whose corner is pulled, and a race about it.
class RaceTest : public EditorTest {
 protected:
  RaceTest() {
    open_grid(6);
    place(0);
    place(35);
    const Vec2 from = pixel_of_handle(1);
    drag(from, from + Vec2(-120, 90));
    settle();
  }

  Race& race() { return editor_->race(); }
  /// Two quick lanes that differ in a number.
  void open_parameter_race() {
    editor_->run_command("race.toggle");
    RaceSetup setup = parameter_race(*find_parameter_row("eta"), race().document());
    setup.values = {1e-1, 1e-3};
    race().set_setup(setup);
  }
  void finish() {
    wait_for([&] { return race().is_finished(); });
  }
  std::size_t longest() {
    std::size_t most = 0;
    for (const auto& lane : race().lanes()) most = std::max(most, lane->records().size());
    return most;
  }
};

TEST_F(RaceTest, NeedsHandles) {
  open_grid(3);
  EXPECT_FALSE(editor_->run_command("race.toggle"));
  EXPECT_FALSE(race().is_open());
}

TEST_F(RaceTest, LanesAreTheMethodsOfTheTable) {
  key(Key::m);
  ASSERT_TRUE(race().is_open());
  ASSERT_EQ(race().lanes().size(), std::clamp(methods().size(), kFewestLanes, kMostLanes));
  EXPECT_EQ(race().lanes().front()->parameters().method, editor_->document().parameters.method);
  for (const auto& lane : race().lanes())
    EXPECT_EQ(lane->title(), find_method(lane->parameters().method)->title);
}

TEST_F(RaceTest, StartsAtRestWithTheSameTargets) {
  open_parameter_race();
  for (const auto& lane : race().lanes()) {
    EXPECT_EQ(lane->shown()->deformed, *lane->shown()->rest) << "nothing has moved at tick 0";
    EXPECT_EQ(lane->shown()->handles, editor_->document().handles);
  }
  RaceSetup setup = race().setup();
  setup.starts_at_rest = false;
  race().set_setup(setup);
  EXPECT_EQ(race().lanes().front()->shown()->deformed, editor_->shown()->deformed);
}

TEST_F(RaceTest, LanesEndWithTheirOutcome) {
  open_parameter_race();
  finish();
  EXPECT_EQ(race().tick(), longest());
  for (const auto& lane : race().lanes()) {
    EXPECT_TRUE(lane->is_at_targets());
    EXPECT_TRUE(lane->words().starts_with("Converged after ")) << lane->words();
    EXPECT_EQ(convergence_letter(*lane), "G");
    EXPECT_TRUE(is_injective_inside(*lane->shown()->triangles, *lane->shown()->rest,
                                    lane->shown()->deformed));
  }
  EXPECT_EQ(race().status().kind, StatusKind::converged);
}

TEST_F(RaceTest, StepsAllLanesByOneIteration) {
  editor_->run_command("race.toggle");
  race().toggle();
  const std::size_t before = race().tick();
  key(Key::period);
  wait_for([&] { return race().tick() > before; });
  EXPECT_EQ(race().tick(), before + 1);
  for (const auto& lane : race().lanes())
    EXPECT_TRUE(lane->is_at_end() || lane->shown()->iteration) << lane->title();
  frame();
  EXPECT_EQ(race().tick(), before + 1) << "and waits there";
}

TEST_F(RaceTest, FollowsThePaceInLockStep) {
  Race race({});
  race.open(editor_->document());
  race.set_pace(10);
  const auto give_up = std::chrono::steady_clock::now() + kPatience;
  const auto has_ended = [](const auto& lane) { return lane->has_ended(); };
  while (!std::ranges::all_of(race.lanes(), has_ended)) {
    ASSERT_LT(std::chrono::steady_clock::now(), give_up);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    race.update(5.0);
  }
  ASSERT_EQ(race.tick(), 1U) << "the lanes are far ahead, but no time has gone by";
  EXPECT_DOUBLE_EQ(race.next_wake().value(), 5.1) << "the next tick comes without an event";
  race.update(5.05);
  EXPECT_EQ(race.tick(), 1U);
  race.update(5.1);
  EXPECT_EQ(race.tick(), 2U);
  for (const auto& lane : race.lanes()) EXPECT_EQ(lane->record(), &lane->records()[1]);
  race.update(9.0);
  EXPECT_EQ(race.tick(), 3U) << "a late frame does not skip iterations";
}

TEST_F(RaceTest, GoesBackAndForthWithoutSolving) {
  open_parameter_race();
  finish();
  const auto end = race().lanes().front()->shown();
  const std::size_t last = race().tick();
  key(Key::comma, kShift);
  EXPECT_EQ(race().tick(), 0U);
  EXPECT_EQ(race().lanes().front()->shown()->deformed, *race().lanes().front()->shown()->rest);
  key(Key::period);
  frame();
  EXPECT_EQ(race().tick(), 1U);
  key(Key::period, kShift);
  frame();
  EXPECT_EQ(race().tick(), last);
  EXPECT_EQ(race().lanes().front()->shown()->deformed, end->deformed);
  EXPECT_FALSE(editor_->next_wake()) << "nothing is left to do";
  EXPECT_FALSE(frame()) << "and nothing to draw";
}

TEST_F(RaceTest, ClosingLeavesTheDocumentAsItWas) {
  const auto pose = editor_->document().pose;
  const auto steps = editor_->draft().history().steps().size();
  const Camera camera = editor_->canvas().camera;
  open_parameter_race();
  finish();
  key(Key::escape);
  EXPECT_FALSE(race().is_open());
  EXPECT_EQ(editor_->document().pose, pose);
  EXPECT_EQ(editor_->draft().history().steps().size(), steps);
  EXPECT_EQ(editor_->canvas().camera, camera);
  EXPECT_EQ(editor_->status().kind, StatusKind::converged);
}

TEST_F(RaceTest, CommandsThatEditAreOffWhileItCoversTheDocument) {
  open_parameter_race();
  for (const char* name : {"edit.undo", "edit.delete", "edit.reset_pose", "file.new", "select.all"})
    EXPECT_FALSE(editor_->run_command(name)) << name;
  EXPECT_TRUE(editor_->run_command("view.heat"));
}

TEST_F(RaceTest, UsingALaneIsOneUndoStep) {
  const Points before = editor_->shown()->deformed;
  const Parameters parameters = editor_->document().parameters;
  open_parameter_race();
  finish();
  const Points result = race().lanes().front()->shown()->deformed;
  editor_->use_race_lane(0);
  frame();
  EXPECT_FALSE(race().is_open());
  EXPECT_EQ(editor_->shown()->deformed, result);
  EXPECT_EQ(editor_->document().parameters.eta, 1e-1);
  EXPECT_TRUE(is_valid());
  editor_->draft().undo();
  EXPECT_EQ(editor_->shown()->deformed, before);
  EXPECT_EQ(editor_->document().parameters, parameters);
  editor_->draft().redo();
  EXPECT_EQ(editor_->shown()->deformed, result);
}

TEST_F(RaceTest, OpeningADocumentClosesIt) {
  open_parameter_race();
  open_grid(4);
  EXPECT_FALSE(race().is_open());
}

TEST_F(RaceTest, OverEnergiesEachLaneMinimisesItsOwn) {
  open_parameter_race();
  race().set_setup(energy_race(race().document()));
  finish();
  std::set<double> energies;
  for (std::size_t i = 0; i < race().lanes().size(); ++i) {
    const RaceLane& lane = *race().lanes()[i];
    EXPECT_EQ(&lane.energy(), race().setup().energies[i]);
    ASSERT_NE(lane.record(), nullptr);
    energies.insert(lane.record()->energy);
    EXPECT_EQ(race().lanes()[i]->title(), lane.energy().title);
  }
  EXPECT_EQ(energies.size(), race().lanes().size());
}

TEST_F(RaceTest, PlacesAreOfThoseThatArrivedByTheirTime) {
  open_parameter_race();
  for (const auto& place : race_places(race())) EXPECT_FALSE(place) << "before the end";
  finish();
  const auto places = race_places(race());
  ASSERT_EQ(places.size(), race().lanes().size());
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t k = 0; k < places.size(); ++k) {
      ASSERT_TRUE(places[i] && places[k]);
      if (*places[i] >= *places[k]) continue;
      EXPECT_LT(race().lanes()[i]->record()->seconds, race().lanes()[k]->record()->seconds);
    }
  EXPECT_NE(std::ranges::find(places, std::optional(1)), places.end());
}

TEST_F(RaceTest, TableAndRecordsAreComplete) {
  open_parameter_race();
  finish();
  std::istringstream table(race_table_csv(race()));
  std::string line;
  std::getline(table, line);
  const auto columns = std::ranges::count(line, ',');
  for (const auto& lane : race().lanes()) {
    ASSERT_TRUE(std::getline(table, line));
    EXPECT_EQ(std::ranges::count(line, ','), columns);
    EXPECT_TRUE(line.starts_with("\"" + lane->title() + "\",\"grid\",36,50,arap,")) << line;
  }
  EXPECT_FALSE(std::getline(table, line));
  const std::string records = race_records_csv(race());
  std::size_t rows = 1;
  for (const auto& lane : race().lanes()) rows += lane->records().size();
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(records, '\n')), rows);
}

}  // namespace
}  // namespace foldless::test
