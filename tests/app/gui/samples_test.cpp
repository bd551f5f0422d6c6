// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/samples.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "app/gui/run_editor.h"

namespace foldless {
namespace {

TEST(FindSamples, NamesFiguresByTheirNumberAndSaysWhatToLookAt) {
  const auto samples = find_samples();
  const auto found = std::ranges::find(samples, "Figure 5: coarse disk", &Sample::title);
  ASSERT_NE(found, samples.end());
  EXPECT_FALSE(found->description.empty());
}

TEST(FindSamples, PutsDrawingsFirst) {
  const auto samples = find_samples();
  ASSERT_GT(samples.size(), 10U);
  EXPECT_EQ(samples[0].title, "Welcome");
  EXPECT_EQ(samples[1].title, "Figure 10: alligator");
}

TEST(FindSamples, CountsFigure11After9) {
  const auto samples = find_samples();
  const auto place = [&samples](std::string_view beginning) {
    return std::ranges::find_if(
        samples, [beginning](const Sample& sample) { return sample.title.starts_with(beginning); });
  };
  ASSERT_NE(place("Figure 11"), samples.end());
  EXPECT_LT(place("Figure 9"), place("Figure 11"));
}

TEST(WelcomeScene, IsOneOfTheSamples) { EXPECT_TRUE(is_sample(welcome_scene())); }

TEST(OpenedFirst, IsTheSampleUntilThereAreRecentFiles) {
  const SessionStart first = opened_first(std::nullopt, {});
  EXPECT_EQ(first.file, welcome_scene());
  EXPECT_TRUE(first.is_sample);
  EXPECT_TRUE(opened_first(std::nullopt, {"/nowhere/scene.json"}).is_sample) << "it is gone";
  const SessionStart later = opened_first(std::nullopt, {"/nowhere/a.json", welcome_scene()});
  EXPECT_TRUE(later.file.empty()) << "the start screen has them";
}

TEST(OpenedFirst, IsWhatWasNamedAndASampleAsACopy) {
  const SessionStart named = opened_first("/tmp/scene.json", {welcome_scene()});
  EXPECT_EQ(named.file, "/tmp/scene.json");
  EXPECT_FALSE(named.is_sample);
  EXPECT_TRUE(opened_first(welcome_scene(), {}).is_sample);
}

TEST(IsSample, LeavesTheUsersOwnFilesAlone) { EXPECT_FALSE(is_sample("/tmp/scene.json")); }

}  // namespace
}  // namespace foldless
