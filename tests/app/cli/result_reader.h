// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <map>

#include "app/cli/manifest.h"
#include "tests/app/cli/command.h"

namespace foldless::test {

/// name → text
using Files = std::map<std::string, std::string>;

/// A reader that keeps to the rules of ResultFolder: name → text of all files that the manifest
/// names; a failure where one is not as the manifest says.
inline Files result_in(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  const fs::path committed = folder / ".foldless-committed";
  const bool is_half_way = fs::exists(committed / kManifest);
  Files files;
  for (const ResultFile& file : read_manifest(is_half_way ? committed : folder)) {
    const fs::path& place = fs::exists(committed / file.name) ? committed : folder;
    EXPECT_EQ(entry_of(place, file.name), file) << file.name << " is of another run";
    files[file.name] = read_text(place / file.name);
  }
  return files;
}

inline void expect_no_leftovers(const std::string& folder) {
  for (const std::string& name : names_in(folder)) EXPECT_FALSE(name.starts_with('.')) << name;
}

}  // namespace foldless::test
