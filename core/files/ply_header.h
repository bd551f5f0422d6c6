// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace foldless {

/// One property of an element of a PLY file.
struct PlyProperty {
  std::string name;
  std::string type;        ///< of the number, or of the items of the list
  std::string count_type;  ///< type of a list's length; empty: not a list
};

/// One kind of element, in the order of the file.
struct PlyElement {
  std::string name;
  std::int64_t count = 0;
  int line = 0;  ///< of the header
  std::vector<PlyProperty> properties;
};

/// The header of a PLY file.
struct PlyHeader {
  std::string format;  ///< ascii, binary_little_endian or binary_big_endian
  std::vector<PlyElement> elements;
  int lines = 0;          ///< of the header
  std::string_view body;  ///< what follows it, part of the bytes that were read
};

/// Reads the header. Throws Error `NAME:LINE: ...` when it is not that of a PLY file.
PlyHeader read_ply_header(std::string_view bytes, const std::string& name);

}  // namespace foldless
