// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/stepped_method.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/core/method/scripted_method.h"

namespace foldless {
namespace {

using test::Guard;
using test::record_of;
using test::Script;
using test::ScriptedMethod;
using Words = std::vector<std::string>;

/// Two updates with a record each, and words round all of them.
Steps<Outcome> two_updates(Script& script) {
  const Guard guard(script, "left");
  const auto next = [&script](std::stop_token) { return script.update(); };
  script.say("begins");
  for (int i = 0; i < 2; ++i) {
    const VertexUpdate update = co_await vertex_update(next);
    script.say("made " + std::to_string(i));
    co_yield record_of(update);
    script.say("recorded " + std::to_string(i));
  }
  co_return Outcome::gradient;
}

TEST(SteppedMethod, RunsUpToItsFirstUpdateWhenItBegins) {
  Script script;
  const ScriptedMethod method(script, two_updates);
  EXPECT_EQ(script.said, Words{"begins"});
  EXPECT_EQ(script.made, 0);
}

TEST(SteppedMethod, WhatFollowsAnUpdateBelongsToTheSameStep) {
  Script script;
  ScriptedMethod method(script, two_updates);
  const auto record = method.step({});
  ASSERT_TRUE(record);
  EXPECT_EQ(record->step_length, 1);
  EXPECT_EQ(script.said, (Words{"begins", "made 0", "recorded 0"}));
  EXPECT_EQ(script.made, 1) << "the next update is that of the next step";
}

TEST(SteppedMethod, TheOutcomeIsKnownRightAfterTheLastRecord) {
  Script script;
  ScriptedMethod method(script, two_updates);
  method.step({});
  EXPECT_FALSE(method.outcome());
  ASSERT_TRUE(method.step({}));
  EXPECT_EQ(method.outcome(), Outcome::gradient);
  EXPECT_EQ(script.said.back(), "left") << "nothing of it is kept";
  EXPECT_FALSE(method.step({}));
  EXPECT_EQ(script.made, 2);
}

TEST(SteppedMethod, ACancelledUpdateIsMadeAgainWithTheNextStepAndNothingElseHappens) {
  Script script;
  ScriptedMethod method(script, two_updates);
  method.step({});
  const Words before = script.said;
  script.cancels = 3;
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(method.step({}));
    EXPECT_FALSE(method.outcome());
  }
  EXPECT_EQ(script.said, before);
  const auto record = method.step({});
  ASSERT_TRUE(record);
  EXPECT_EQ(record->step_length, 2);
  EXPECT_EQ(script.cancelled, 3);
  EXPECT_EQ(method.outcome(), Outcome::gradient);
}

TEST(SteppedMethod, AStepWhoseTokenIsSetAsksForNoUpdate) {
  Script script;
  ScriptedMethod method(script, two_updates);
  std::stop_source stopped;
  stopped.request_stop();
  EXPECT_FALSE(method.step(stopped.get_token()));
  EXPECT_EQ(script.made, 0);
}

TEST(SteppedMethod, BeginningAnewLeavesWhatItWasAbout) {
  Script script;
  ScriptedMethod method(script, two_updates);
  method.step({});
  script.said.clear();
  method.set_targets({});
  EXPECT_EQ(script.said, (Words{"left", "begins"}));
  method.step({});
  method.step({});
  EXPECT_EQ(method.outcome(), Outcome::gradient);
  method.set_targets({});
  EXPECT_FALSE(method.outcome());
  EXPECT_TRUE(method.step({}));
}

TEST(SteppedMethod, DestroyingItWhileItWaitsIsSafe) {
  Script script;
  {
    ScriptedMethod method(script, two_updates);
    method.step({});
    script.said.clear();
  }
  EXPECT_EQ(script.said, Words{"left"});
}

/// Like a relaxation that has nothing to do: the update in the middle has no record.
Steps<Outcome> silent_update(Script& script) {
  const auto next = [&script](std::stop_token) { return script.update(); };
  co_yield record_of(co_await vertex_update(next));
  co_await vertex_update(next);
  co_yield record_of(co_await vertex_update(next));
  co_await vertex_update(next);
  co_return Outcome::step;
}

TEST(SteppedMethod, AnUpdateWithoutARecordDoesNotEndAStep) {
  Script script;
  ScriptedMethod method(script, silent_update);
  EXPECT_EQ(method.step({})->step_length, 1);
  EXPECT_EQ(method.step({})->step_length, 3);
  EXPECT_FALSE(method.outcome());
  EXPECT_FALSE(method.step({})) << "the end may come without a record";
  EXPECT_EQ(method.outcome(), Outcome::step);
  EXPECT_EQ(script.made, 4);
}

TEST(SteppedMethod, AfterAnUpdateWithoutARecordAStopIsObeyed) {
  Script script;
  script.stops_at = 2;
  ScriptedMethod method(script, silent_update);
  EXPECT_TRUE(method.step(script.stop.get_token()));
  EXPECT_FALSE(method.step(script.stop.get_token()));
  EXPECT_EQ(script.made, 2);
  EXPECT_EQ(method.step({})->step_length, 3);
}

/// Like a large mesh whose flips take long.
Steps<Outcome> pause_before_the_record(Script& script) {
  const auto next = [&script](std::stop_token) { return script.update(); };
  const VertexUpdate update = co_await vertex_update(next);
  script.say("long");
  co_await Pause();
  script.say("longer");
  co_yield record_of(update);
  co_return Outcome::step;
}

TEST(SteppedMethod, AtAPauseAStopIsObeyedAndTheNextStepGoesOnThere) {
  Script script;
  script.stops_at = 1;
  ScriptedMethod method(script, pause_before_the_record);
  EXPECT_FALSE(method.step(script.stop.get_token()));
  EXPECT_FALSE(method.outcome());
  EXPECT_EQ(script.said, Words{"long"});
  EXPECT_EQ(method.step({})->step_length, 1) << "the same update";
  EXPECT_EQ(script.said, (Words{"long", "longer"}));
}

TEST(SteppedMethod, AnUpdateWithoutARecordIsNotMadeTwiceWhereTheNextIsCancelled) {
  Script script;
  ScriptedMethod method(script, [](Script& s) -> Steps<Outcome> {
    const auto next = [&s](std::stop_token) { return s.update(); };
    co_await vertex_update(next);
    s.cancels = 1;
    co_yield record_of(co_await vertex_update(next));
    co_return Outcome::step;
  });
  EXPECT_FALSE(method.step({}));
  EXPECT_EQ(script.made, 1);
  EXPECT_FALSE(method.outcome());
  EXPECT_EQ(method.step({})->step_length, 2);
}

TEST(SteppedMethod, WhatEndsWithoutAnUpdateHasEndedBeforeAnyStep) {
  Script script;
  ScriptedMethod method(script, [](Script&) -> Steps<Outcome> { co_return Outcome::infeasible; });
  EXPECT_EQ(method.outcome(), Outcome::infeasible);
  EXPECT_FALSE(method.step({}));
}

TEST(SteppedMethod, ARecordMayBeCorrectedUpToTheNextUpdate) {
  Script script;
  ScriptedMethod method(script, [](Script& s) -> Steps<Outcome> {
    const auto next = [&s](std::stop_token) { return s.update(); };
    const auto correct = [](Iteration& record) { record.energy = 7; };
    co_yield correct;  // there is none yet
    co_yield record_of(co_await vertex_update(next));
    co_yield correct;
    co_yield record_of(co_await vertex_update(next));
    co_return Outcome::step;
  });
  const auto first = method.step({}), second = method.step({});
  EXPECT_EQ(first->energy, 7);
  EXPECT_EQ(first->step_length, 1);
  EXPECT_EQ(second->energy, 0);
}

TEST(SteppedMethod, TheSecondsOfRecordsNeverGoBack) {
  Script script;
  ScriptedMethod method(script, [](Script& s) -> Steps<Outcome> {
    const auto next = [&s](std::stop_token) {
      const double start = thread_seconds();
      while (thread_seconds() < start + 1e-4) {
      }
      return s.update();
    };
    while (true) co_yield record_of(co_await vertex_update(next));
  });
  double seconds = 0;
  for (int i = 1; i <= 5; ++i) {
    if (i == 3) method.set_targets({});
    const auto record = method.step({});
    EXPECT_GE(record->seconds, seconds + 1e-4) << "they add up, whatever began anew";
    seconds = record->seconds;
  }
}

TEST(SteppedMethod, OfAStageThatWaitsOnlyTheShareOfItsStepIsProcessorTime) {
  Script script;
  ScriptedMethod method(script, [](Script& s) -> Steps<Outcome> {
    const auto next = [&s](std::stop_token) {
      const StageTimer timer(*s.stage);
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      return s.update();
    };
    co_yield record_of(co_await vertex_update(next));
    co_return Outcome::gradient;
  });
  script.stage = &method.effort().times.solve;
  EXPECT_EQ(method.times().total(), 0);
  const auto record = method.step({});
  EXPECT_GE(method.effort().times.solve, 2e-3) << "by the clock on the wall";
  EXPECT_GT(method.times().solve, 0);
  EXPECT_LE(method.times().solve, record->seconds);
  EXPECT_EQ(method.times().total(), method.times().solve);
}

TEST(SteppedMethod, WhatAnUpdateThrowsComesOutOfTheStepAndTheUpdateCanBeMadeAgain) {
  Script script;
  ScriptedMethod method(script, two_updates);
  script.fails = true;
  EXPECT_THROW(method.step({}), std::runtime_error);
  EXPECT_FALSE(method.outcome());
  ASSERT_TRUE(method.step({}));
  EXPECT_EQ(script.made, 1);
}

/// Throws after its first update.
Steps<Outcome> failing(Script& script) {
  const Guard guard(script, "left");
  const auto next = [&script](std::stop_token) { return script.update(); };
  co_yield record_of(co_await vertex_update(next));
  if (script.made % 2 == 1) throw std::runtime_error("after an update");
  co_return Outcome::step;
}

TEST(SteppedMethod, WhatItsStepsThrowComesOutOfTheStepAndItCanBeginAnew) {
  Script script;
  ScriptedMethod method(script, failing);
  EXPECT_THROW(method.step({}), std::runtime_error);
  EXPECT_EQ(script.said, Words{"left"});
  EXPECT_FALSE(method.outcome());
  EXPECT_FALSE(method.step({})) << "there is nothing to go on with";
  method.set_targets({});
  EXPECT_TRUE(method.step({}));
  EXPECT_EQ(method.outcome(), Outcome::step);
}

TEST(SteppedMethod, WhatIsThrownBeforeTheFirstUpdateComesOutOfTheBeginning) {
  Script script;
  const auto fails = [](Script&) -> Steps<Outcome> {
    throw std::runtime_error("at once");
    co_return Outcome::step;
  };
  EXPECT_THROW(ScriptedMethod(script, fails), std::runtime_error);
}

}  // namespace
}  // namespace foldless
