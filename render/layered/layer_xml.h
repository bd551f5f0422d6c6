// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pugixml.hpp>
#include <string>

#include "render/layered/zip_archive.h"

namespace foldless {

/// Groups within groups are followed this far.
inline constexpr int kDeepestGroup = 100;

/// What an element says of the layers in it and of those that hold it.
struct LayerGroup {
  int depth = 0;
  int x = 0, y = 0;  ///< added to those of its layers
  double opacity = 1;
  bool is_visible = true;
};

/// Reads a file of an archive. Entities of its own are not expanded. Throws Error when it is
/// missing, too large or no XML.
pugi::xml_document read_xml(const ZipArchive& archive, const std::string& name);

/// The integer or number of an attribute, or what stands in for it where there is none. Throws
/// Error when it is something else.
int integer_at(const pugi::xml_node& node, const char* attribute, int otherwise);
double number_at(const pugi::xml_node& node, const char* attribute, double otherwise);

/// The group within another. Throws Error where groups are nested too deeply.
LayerGroup group_within(const LayerGroup& outer, LayerGroup inner);

}  // namespace foldless
