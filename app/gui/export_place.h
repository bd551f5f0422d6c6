// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "app/editor/editor.h"
#include "app/gui/ui_state.h"

namespace foldless {

/// The folder where the user was last: of the last dialog, of the document, or the present one.
std::filesystem::path starting_folder(const Editor& editor, const UiState& state);

/// A name without extension for a new file of this document.
std::string suggested_name(const Editor& editor);

/// The file that a dialog for exports begins with: beside what the document is made of, or where
/// the last export of it went, and never one of those files.
std::filesystem::path suggested_export(const Editor& editor, const UiState& state,
                                       const std::string& ending);

/// The next export of this document begins in that folder.
void remember_export(const Editor& editor, UiState& state, const std::filesystem::path& path);

/// Throws Error where an export would replace the scene, the picture or the mesh that it is made
/// of.
void expect_no_export_of_source(const Editor& editor, const std::filesystem::path& path);

}  // namespace foldless
