// SPDX-License-Identifier: GPL-3.0-or-later
// Steps within steps, and what they give each other.
#include "core/method/steps.h"

#include <gtest/gtest.h>

#include <memory>

#include "tests/core/method/foldless/stage_runner.h"
#include "tests/core/method/scripted_method.h"

namespace foldless {
namespace {

using test::Guard;
using test::record_of;
using test::Script;
using test::StageRunner;
using Words = std::vector<std::string>;

/// So many updates; the sum of their numbers.
Steps<int> sum_of_updates(Script& script, int count) {
  const Guard guard(script, "inner left");
  const auto next = [&script](std::stop_token) { return script.update(); };
  int sum = 0;
  for (int i = 0; i < count; ++i) {
    const VertexUpdate update = co_await vertex_update(next);
    sum += static_cast<int>(update.step_length);
    co_yield record_of(update);
  }
  co_return sum;
}

Steps<std::string> two_sums(Script& script) {
  const Guard guard(script, "outer left");
  const int none = co_await sum_of_updates(script, 0);
  const int first = co_await sum_of_updates(script, 2);
  script.say("between");
  const int second = co_await sum_of_updates(script, 3);
  co_return std::to_string(none) + ' ' + std::to_string(first) + ' ' + std::to_string(second);
}

TEST(Steps, WithinStepsGiveTheirResults) {
  Script script;
  StageRunner<std::string> runner(two_sums(script));
  EXPECT_TRUE(runner.run());
  EXPECT_EQ(runner.result(), "0 3 12");
  EXPECT_EQ(runner.records().size(), 5U);
}

TEST(Steps, AfterInnerOnesTheOuterOnesGoOnInTheSameStep) {
  Script script;
  StageRunner<std::string> runner(two_sums(script));
  runner.run(2);
  EXPECT_EQ(script.said, (Words{"inner left", "inner left", "between"}));
  EXPECT_EQ(script.made, 2);
  runner.run(3);
  EXPECT_TRUE(runner.has_ended());
}

TEST(Steps, ThatWaitAreDestroyedFromTheInsideOut) {
  Script script;
  {
    StageRunner<std::string> runner(two_sums(script));
    runner.step();
    script.said.clear();
  }
  EXPECT_EQ(script.said, (Words{"inner left", "outer left"}));
}

TEST(Steps, ACancelledUpdateOfInnerStepsIsMadeAgain) {
  Script script;
  StageRunner<std::string> runner(two_sums(script));
  for (int step = 0; !runner.has_ended(); ++step) {
    script.cancels = step % 3;
    for (int i = script.cancels; i > 0; --i) EXPECT_FALSE(runner.step());
    EXPECT_TRUE(runner.step());
  }
  EXPECT_EQ(runner.result(), "0 3 12");
  EXPECT_EQ(runner.records().size(), 5U);
}

Steps<> failing(Script& script, bool at_once) {
  const Guard guard(script, "inner left");
  if (at_once) throw std::runtime_error("at once");
  const auto next = [&script](std::stop_token) { return script.update(); };
  co_await vertex_update(next);
  throw std::runtime_error("after an update");
}

Steps<Words> catching(Script& script) {
  Words caught;
  for (const bool at_once : {true, false}) {
    try {
      co_await failing(script, at_once);
    } catch (const std::runtime_error& error) {
      caught.emplace_back(error.what());
    }
  }
  co_return caught;
}

TEST(Steps, WhatInnerOnesThrowComesOutWhereTheyAreAwaited) {
  Script script;
  StageRunner<Words> runner(catching(script));
  runner.run();
  EXPECT_EQ(runner.result(), (Words{"at once", "after an update"}));
  EXPECT_EQ(script.said, (Words{"inner left", "inner left"}));
}

Steps<int> not_catching(Script& script) {
  co_await failing(script, false);
  co_return 1;
}

TEST(Steps, WhatNobodyCatchesIsTheResult) {
  Script script;
  StageRunner<int> runner(not_catching(script));
  EXPECT_FALSE(runner.has_ended());
  runner.step();
  ASSERT_TRUE(runner.has_ended());
  EXPECT_THROW(runner.result(), std::runtime_error);
}

Steps<std::optional<int>> perhaps(std::optional<int> value) { co_return value; }
Steps<std::optional<int>> nothing() { co_return std::nullopt; }

Steps<Words> optional_results() {
  const std::optional<int> three = co_await perhaps(3);
  const std::optional<int> none = co_await perhaps(std::nullopt);
  const std::optional<int> null = co_await nothing();
  Words words;
  for (const std::optional<int>& value : {three, none, null})
    words.push_back(value ? std::to_string(*value) : "nothing");
  co_return words;
}

TEST(Steps, ResultsMayBeOptional) {
  StageRunner<Words> runner(optional_results());
  EXPECT_EQ(runner.result(), (Words{"3", "nothing", "nothing"}));
}

/// Updates that are cancelled, nothing to do, and one.
Steps<Words> optional_updates(Script& script) {
  const auto next = [&script](std::stop_token) -> std::optional<VertexUpdate> {
    const VertexUpdate update = script.update();
    if (!update.cancelled && update.step_length == 1) return std::nullopt;
    return update;
  };
  Words words;
  for (int i = 0; i < 2; ++i) {
    const std::optional<VertexUpdate> update = co_await vertex_update(next);
    words.push_back(update ? "update" : "nothing");
    co_yield Iteration();
  }
  co_return words;
}

TEST(Steps, AnUpdateMayBeNothingWhichIsNoCancellation) {
  Script script;
  script.cancels = 1;
  StageRunner<Words> runner(optional_updates(script));
  EXPECT_FALSE(runner.step()) << "cancelled";
  EXPECT_TRUE(runner.step());
  EXPECT_TRUE(runner.step());
  EXPECT_EQ(runner.result(), (Words{"nothing", "update"}));
}

Steps<std::unique_ptr<int>> unique() { co_return std::make_unique<int>(5); }

TEST(Steps, ResultsMayBeOfAKindThatOnlyMoves) {
  StageRunner<std::unique_ptr<int>> runner(unique());
  EXPECT_EQ(*runner.result(), 5);
}

/// Awaits itself that deep.
Steps<int> nested(Script& script, int depth) {
  if (depth > 0) co_return 1 + co_await nested(script, depth - 1);
  const auto next = [&script](std::stop_token) { return script.update(); };
  co_yield record_of(co_await vertex_update(next));
  co_return 0;
}

TEST(Steps, MayBeNestedDeeply) {
  Script script;
  StageRunner<int> runner(nested(script, 200));
  EXPECT_TRUE(runner.step());
  EXPECT_EQ(runner.result(), 200);
}

}  // namespace
}  // namespace foldless
