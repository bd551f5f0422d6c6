// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "core/error.h"
#include "core/files/text_lines.h"

namespace foldless {
namespace {

class HeaderReader {
 public:
  HeaderReader(std::string_view bytes, const std::string& name) : rest_(bytes), name_(name) {}

  PlyHeader read() {
    if (next_line() != "ply") refuse("a PLY file begins with the line 'ply'");
    for (;;) {
      Words words(next_line());
      const std::string_view keyword = words.next();
      if (keyword == "end_header") break;
      if (keyword == "format")
        read_format(words);
      else if (keyword == "element")
        read_element(words);
      else if (keyword == "property")
        read_property(words);
      else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info")
        refuse("the header has the unknown word " + in_quotes(keyword));
    }
    if (header_.format.empty()) refuse("the header does not give a format");
    header_.body = rest_;
    return std::move(header_);
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw Error(name_ + ':' + std::to_string(std::max(1, header_.lines)) + ": " + what);
  }

  /// Ends in LF or CRLF only, because a binary body may follow.
  std::string_view next_line() {
    const std::size_t end = rest_.find('\n');
    if (end == rest_.npos) refuse("the header of the PLY file has no end");
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    ++header_.lines;
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  }

  void read_format(Words words) {
    const std::string_view format = words.next();
    if (format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian")
      refuse("the format " + in_quotes(format) + " is unknown");
    header_.format = format;
  }

  void read_element(Words words) {
    PlyElement element{std::string(words.next()), 0, header_.lines, {}};
    const std::string_view count = words.next();
    const auto [end, error] =
        std::from_chars(count.data(), count.data() + count.size(), element.count);
    if (error != std::errc() || end != count.data() + count.size() || element.count < 0)
      refuse("the element " + in_quotes(element.name) + " has the count " + in_quotes(count));
    header_.elements.push_back(std::move(element));
  }

  std::string read_type(std::string_view type) const {
    constexpr std::array kTypes{"char",  "uchar",  "short",   "ushort", "int",   "uint",
                                "int8",  "uint8",  "int16",   "uint16", "int32", "uint32",
                                "float", "double", "float32", "float64"};
    if (std::ranges::find(kTypes, type) == kTypes.end())
      refuse("the type " + in_quotes(type) + " is unknown");
    return std::string(type);
  }

  void read_property(Words words) {
    if (header_.elements.empty()) refuse("a property comes before every element");
    PlyProperty property;
    std::string_view type = words.next();
    if (type == "list") {
      property.count_type = read_type(words.next());
      type = words.next();
    }
    property.type = read_type(type);
    property.name = words.next();
    header_.elements.back().properties.push_back(std::move(property));
  }

  std::string_view rest_;
  const std::string& name_;
  PlyHeader header_;
};

}  // namespace

PlyHeader read_ply_header(std::string_view bytes, const std::string& name) {
  return HeaderReader(bytes, name).read();
}

}  // namespace foldless
