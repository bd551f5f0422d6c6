// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/parameter_rows.h"

#include <gtest/gtest.h>

#include <set>

#include "core/energy/densities.h"

namespace foldless {
namespace {

TEST(ParameterRows, DefaultsAreInRangeAndUnchanged) {
  for (const Density& energy : densities())
    for (const ParameterRow& row : parameter_rows()) {
      const double value = default_of(row, Parameters{}, energy);
      EXPECT_GE(value, row.minimum) << row.name << " of " << energy.name;
      EXPECT_LE(value, row.maximum) << row.name << " of " << energy.name;
      EXPECT_FALSE(is_changed(row, Parameters{}, energy)) << row.name;
    }
}

TEST(ParameterRows, SettingChangesAndResettingRestores) {
  const Density& energy = densities().front();
  for (const ParameterRow& row : parameter_rows()) {
    Parameters parameters;
    const double other =
        default_of(row, Parameters{}, energy) == row.maximum ? row.minimum : row.maximum;
    row.set(parameters, other);
    EXPECT_EQ(row.get(parameters, energy), other) << row.name;
    EXPECT_TRUE(is_changed(row, parameters, energy)) << row.name;
    row.reset(parameters);
    EXPECT_EQ(parameters, Parameters{}) << row.name;
  }
}

TEST(ParameterRows, EveryRowHasItsOwnNameAndWords) {
  std::set<std::string_view> names;
  for (const ParameterRow& row : parameter_rows()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_EQ(find_parameter_row(row.name), &row);
    EXPECT_FALSE(row.title.empty());
    EXPECT_TRUE(row.tooltip.ends_with(".")) << row.name;
  }
  EXPECT_EQ(find_parameter_row("gamma"), nullptr);
}

}  // namespace
}  // namespace foldless
