// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data_path.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/support/errors.h"
#include "tests/support/temporary_folder.h"

namespace foldless {
namespace {

/// Sets FOLDLESS_DATA_DIR for as long as it lives.
class DataFolder {
 public:
  explicit DataFolder(const std::filesystem::path& path) {
    ::setenv("FOLDLESS_DATA_DIR", path.c_str(), 1);
  }
  ~DataFolder() { ::unsetenv("FOLDLESS_DATA_DIR"); }
  DataFolder(const DataFolder&) = delete;
  DataFolder& operator=(const DataFolder&) = delete;
};

TEST(DataPath, AProgramThatIsNotInstalledFindsTheSourceTree) {
  EXPECT_TRUE(std::filesystem::exists(data_path("shaders/fill.vert")));
}

TEST(DataPath, TheVariableComesFirst) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder / "shaders");
  const DataFolder variable(folder.path());
  EXPECT_EQ(data_path("shaders"), folder / "shaders");
}

TEST(DataPath, WhatTheVariableLacksIsFoundElsewhere) {
  const test::TemporaryFolder folder;
  const DataFolder variable(folder.path());
  EXPECT_TRUE(std::filesystem::exists(data_path("shaders")));
}

TEST(DataPath, NamesWhatIsMissing) {
  const std::string sentence = test::error_of([] { data_path("no/such/thing"); });
  EXPECT_NE(sentence.find("no/such/thing"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("FOLDLESS_DATA_DIR"), std::string::npos) << sentence;
}

}  // namespace
}  // namespace foldless
