// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/late_function.h"

#include <gtest/gtest.h>

#include <string>

#include "core/error.h"

namespace foldless {
namespace {

constexpr LateLibrary kMath{"libm.so.6", "nothing can be counted", "libc6"};
constexpr LateLibrary kNone{"libfoldless-none.so.1", "nothing can be drawn", "libnone1"};

using OfNumber = double(double);

std::string words_of(const LateFunction<OfNumber>& function) {
  try {
    function(1);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(LateFunction, IsCalledAsTheFunctionOfTheLibrary) {
  const LateFunction<OfNumber> below(kMath, "floor");
  EXPECT_EQ(below(2.5), 2);
  EXPECT_EQ(below(-2.5), -3);
}

TEST(LateFunction, IsPassedOnAsTheFunctionOfTheLibrary) {
  const LateFunction<OfNumber> below(kMath, "floor");
  OfNumber* const passed_on = below;
  EXPECT_EQ(passed_on(2.5), 2);
}

TEST(LateFunction, OfALibraryThatIsNotThereSaysWhatFailsAndWhatToInstall) {
  const std::string words = words_of({kNone, "floor"});
  EXPECT_TRUE(words.starts_with("nothing can be drawn: libfoldless-none.so.1: ")) << words;
  EXPECT_TRUE(words.ends_with("; install libnone1")) << words;
}

TEST(LateFunction, ThatTheLibraryDoesNotHaveSaysWhatFailsAndWhatToInstall) {
  const std::string words = words_of({kMath, "foldless_none"});
  EXPECT_TRUE(words.starts_with("nothing can be counted: ")) << words;
  EXPECT_TRUE(words.ends_with("; install libc6")) << words;
}

}  // namespace
}  // namespace foldless
