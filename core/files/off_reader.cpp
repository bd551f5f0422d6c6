// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "core/error.h"
#include "core/files/mesh_readers.h"
#include "core/files/text_lines.h"
#include "core/files/vertex_line.h"

namespace foldless {
namespace {

/// The optional prefixes of the header word, in Geomview's order.
bool is_header(std::string_view word) {
  for (const std::string_view prefix : {"ST", "C", "N"})
    if (word.starts_with(prefix)) word.remove_prefix(prefix.size());
  return word == "OFF";
}

class OffReader {
 public:
  OffReader(std::string_view text, std::string name) : lines_(text) {
    soup_.source.name = std::move(name);
  }

  PolygonSoup read() {
    read_counts();
    for (int v = 0; v < vertices_; ++v) {
      const Words words = expect_words(v, vertices_, "vertex");
      read_vertex_line(words, lines_.number(), soup_, bad_coordinates_);
    }
    for (int f = 0; f < faces_; ++f) read_face(f);
    bad_coordinates_.refuse();
    bad_corners_.refuse();
    short_faces_.refuse();
    return std::move(soup_);
  }

 private:
  [[noreturn]] void refuse_here(const std::string& what) const {
    throw Error(soup_.source.name + ':' + std::to_string(std::max(1, lines_.number())) + ": " +
                what);
  }

  /// The words of the next line that has any; nothing at the end of the file.
  std::optional<Words> next_words() {
    while (lines_.next()) {
      const std::string_view line = without_comment(lines_.line());
      if (!Words(line).next().empty()) return Words(line);
    }
    return std::nullopt;
  }

  Words expect_words(int read, int promised, std::string_view noun) {
    const auto words = next_words();
    if (!words)
      refuse_here("the file ends after " + std::to_string(read) + " of " +
                  counted(static_cast<std::size_t>(promised), noun) + "; it has been cut short");
    return *words;
  }

  int expect_count(std::string_view word) const {
    const auto count = parse_integer(word);
    if (!count || *count < 0)
      refuse_here("the numbers of vertices and faces are expected, not " + in_quotes(word));
    return *count;
  }

  void read_counts() {
    auto words = next_words();
    if (!words) return;  // nothing at all: a mesh without faces
    Words rest = *words;
    std::string_view word = rest.next();
    if (!parse_number(word)) {
      if (!is_header(word)) refuse_here("an OFF file begins with OFF, not with " + in_quotes(word));
      word = rest.next();
      if (word == "BINARY") refuse_here("this OFF file is binary; save it as text");
      if (word.empty()) {
        if (!(words = next_words())) return;
        rest = *words;
        word = rest.next();
      }
    }
    vertices_ = expect_count(word);
    faces_ = expect_count(rest.next());
  }

  void read_face(int f) {
    Words words = expect_words(f, faces_, "face");
    soup_.source.face_lines.push_back(lines_.number());
    const std::string_view size = words.next();
    const int corners = parse_integer(size).value_or(-1);
    if (corners < 0)
      bad_corners_.add([&] {
        return soup_.source.at_face(f) + " has the number of corners " + in_quotes(size);
      });
    else if (corners < 3)
      short_faces_.add([&] {
        return soup_.source.at_face(f) + " has " +
               counted(static_cast<std::size_t>(corners), "corner");
      });
    for (int k = 0; k < corners; ++k)
      if (!read_corner(words.next(), f)) break;
    soup_.end_face();
  }

  bool read_corner(std::string_view word, int f) {
    const auto index = parse_integer(word);
    if (!index)
      bad_corners_.add([&] {
        return soup_.source.at_face(f) + " has the corner " + in_quotes(word) +
               ", which is not a vertex number";
      });
    soup_.corners.push_back(index.value_or(0));
    return index.has_value();
  }

  TextLines lines_;
  PolygonSoup soup_;
  int vertices_ = 0;
  int faces_ = 0;
  Offenders bad_coordinates_{"vertex", "a vertex needs two or three numbers: x y z"};
  Offenders bad_corners_{"face", "a face is a number of corners and as many vertex numbers"};
  Offenders short_faces_{"face", "a face needs at least three corners"};
};

}  // namespace

PolygonSoup read_off(std::string_view text, std::string name) {
  return OffReader(text, std::move(name)).read();
}

}  // namespace foldless
