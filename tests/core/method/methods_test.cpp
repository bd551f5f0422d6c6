// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/methods.h"

#include <gtest/gtest.h>

#include "core/energy/densities.h"
#include "core/method/foldless/foldless.h"
#include "core/scene/parameter_keys.h"

namespace foldless {
namespace {

TEST(Methods, EveryParameterIsReadByAMethodAndEveryNameIsAParameter) {
  for (const ParameterKey& key : parameter_keys()) {
    int readers = 0;
    for (const MethodRow& method : methods()) readers += reads(method, key.name);
    EXPECT_GT(readers, 0) << key.name;
  }
  for (const MethodRow& method : methods())
    for (const std::string_view name : method.parameters) {
      int keys = 0;
      for (const ParameterKey& key : parameter_keys()) keys += key.name == name;
      EXPECT_EQ(keys, 1) << method.name << " " << name;
    }
}

TEST(Methods, OnlyFoldlessHasABetaOfItsOwn) {
  for (const Density& energy : densities()) {
    EXPECT_EQ(default_beta("paper", energy), energy.default_beta);
    EXPECT_EQ(default_beta("foldless", energy), Foldless::kBeta);
  }
}

}  // namespace
}  // namespace foldless
