// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/sources.h"

#include <system_error>

#include "core/error.h"

namespace foldless {
namespace {

/// False where one of them is not there.
bool are_one_file(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code ignored;
  return std::filesystem::equivalent(a, b, ignored);
}

}  // namespace

bool is_source(const Document& document, const std::filesystem::path& path) {
  return are_one_file(path, document.texture) || are_one_file(path, document.mesh_file);
}

void expect_no_source(const Document& document, const std::filesystem::path& path) {
  if (!is_source(document, path)) return;
  const bool is_texture = are_one_file(path, document.texture);
  throw Error(path.string() + ": " + (is_texture ? "the picture" : "the mesh") +
              " on screen is made of it; choose another name.");
}

std::filesystem::path folder_of_sources(const Document& document) {
  return (document.texture.empty() ? document.mesh_file : document.texture).parent_path();
}

}  // namespace foldless
