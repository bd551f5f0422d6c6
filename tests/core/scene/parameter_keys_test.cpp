// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/parameter_keys.h"

#include <gtest/gtest.h>

#include <cmath>

namespace foldless {
namespace {

TEST(ParameterKeys, SetWhatTheyGet) {
  for (const ParameterKey& key : parameter_keys()) {
    Parameters parameters;
    const double value = key.kind == ParameterKind::whole  ? 17
                         : key.kind == ParameterKind::flag ? 0
                         : key.kind == ParameterKind::word ? 1
                                                           : 0.375;
    key.set(parameters, value);
    EXPECT_EQ(key.get(parameters), value) << key.name;
    EXPECT_NE(parameters, Parameters()) << key.name;
    EXPECT_EQ(find_parameter_key(key.name), &key);
  }
  EXPECT_EQ(find_parameter_key("gamma"), nullptr);
}

TEST(ParameterKeys, WordsHaveAnIndexEach) {
  const ParameterKey& start = *find_parameter_key("start");
  EXPECT_EQ(index_of_word(start, "rest"), 0);
  EXPECT_EQ(index_of_word(start, "continuation"), static_cast<double>(StartFrames::continuation));
  EXPECT_FALSE(index_of_word(start, "later"));
}

TEST(ParameterKeys, AllowTheDefaults) {
  for (const ParameterKey& key : parameter_keys()) {
    const auto value = key.get(Parameters());
    EXPECT_FALSE(value && objection(key, *value)) << key.name;
  }
}

TEST(ParameterKeys, ObjectToWhatIsNotFinite) {
  for (const ParameterKey& key : parameter_keys())
    for (const double value : {std::nan(""), HUGE_VAL, -HUGE_VAL, -1.0})
      EXPECT_TRUE(objection(key, value)) << key.name << ' ' << value;
}

}  // namespace
}  // namespace foldless
