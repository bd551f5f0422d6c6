// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/export_place.h"

#include <system_error>

#include "app/editor/sources.h"
#include "app/gui/samples.h"
#include "core/error.h"

namespace foldless {
namespace {

bool is_scene_file(const Editor& editor, const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::equivalent(path, editor.files().path(), ignored);
}

/// Empty: the document came from nowhere, or with the program.
std::filesystem::path folder_of(const Editor& editor) {
  if (!editor.files().path().empty())
    return std::filesystem::absolute(editor.files().path()).parent_path();
  const std::filesystem::path folder = folder_of_sources(editor.document());
  return is_data_folder(folder) ? std::filesystem::path() : folder;
}

}  // namespace

std::filesystem::path starting_folder(const Editor& editor, const UiState& state) {
  if (!state.last_folder.empty()) return state.last_folder;
  if (auto own = folder_of(editor); !own.empty()) return own;
  std::error_code ignored;
  return std::filesystem::current_path(ignored);
}

std::string suggested_name(const Editor& editor) {
  if (!editor.files().path().empty()) return editor.files().path().stem().string();
  const std::string& name = editor.document().name;
  return name.empty() ? "scene" : std::filesystem::path(name).stem().string();
}

std::filesystem::path suggested_export(const Editor& editor, const UiState& state,
                                       const std::string& ending) {
  const std::filesystem::path own = folder_of(editor);
  std::filesystem::path folder = own.empty() ? starting_folder(editor, state) : own;
  if (!state.exported_to.empty() && state.exported_from == own) folder = state.exported_to;
  const std::string name = suggested_name(editor);
  std::filesystem::path file = folder / (name + ending);
  const bool is_taken = is_source(editor.document(), file) || is_scene_file(editor, file);
  return is_taken ? folder / (name + "-posed" + ending) : file;
}

void remember_export(const Editor& editor, UiState& state, const std::filesystem::path& path) {
  state.exported_from = folder_of(editor);
  state.exported_to = path.parent_path();
}

void expect_no_export_of_source(const Editor& editor, const std::filesystem::path& path) {
  expect_no_source(editor.document(), path);
  if (is_scene_file(editor, path))
    throw Error(path.string() + ": this scene is saved in it; choose another name.");
}

}  // namespace foldless
