// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/editor/document.h"

namespace foldless {

/// The files that a document is made of beside its scene file: the image of its texture and its
/// mesh. Written under another path that leads to it, such a file would be gone as well.
bool is_source(const Document& document, const std::filesystem::path& path);

/// Throws Error, which says so in a sentence, where is_source().
void expect_no_source(const Document& document, const std::filesystem::path& path);

/// Where they are, the image first; empty: there are none.
std::filesystem::path folder_of_sources(const Document& document);

}  // namespace foldless
