// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/files/mesh_readers.h"
#include "core/files/text_lines.h"
#include "core/files/vertex_line.h"

namespace foldless {
namespace {

/// Lines joined where one ends in a backslash; number() is the first of them.
class ContinuedLines {
 public:
  explicit ContinuedLines(std::string_view text) : lines_(text) {}

  bool next() {
    if (!lines_.next()) return false;
    number_ = lines_.number();
    line_ = lines_.line();
    if (!line_.ends_with('\\')) return true;
    joined_.clear();
    while (line_.ends_with('\\')) {
      joined_.append(line_.substr(0, line_.size() - 1)).push_back(' ');
      line_ = lines_.next() ? lines_.line() : std::string_view();
    }
    line_ = joined_.append(line_);
    return true;
  }
  std::string_view line() const { return without_comment(line_); }
  int number() const { return number_; }

 private:
  TextLines lines_;
  std::string joined_;
  std::string_view line_;
  int number_ = 0;
};

class ObjReader {
 public:
  explicit ObjReader(std::string name) {
    soup_.source.name = std::move(name);
    soup_.source.first_index = 1;
  }

  PolygonSoup read(std::string_view text) {
    for (ContinuedLines lines(text); lines.next();) {
      Words words(lines.line());
      const std::string_view keyword = words.next();
      if (keyword == "v") read_vertex_line(words, lines.number(), soup_, bad_coordinates_);
      if (keyword == "f") read_face(words, lines.number());
    }
    bad_coordinates_.refuse();
    bad_corners_.refuse();
    short_faces_.refuse();
    bad_references_.refuse();
    return std::move(soup_);
  }

 private:
  void read_face(Words words, int line) {
    const std::size_t begin = soup_.corners.size();
    const int f = soup_.face_count();
    soup_.source.face_lines.push_back(line);
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
      const auto index = parse_integer(word.substr(0, word.find('/')));
      if (!index)
        bad_corners_.add([&] {
          return soup_.source.at_face(f) + " has the corner " + in_quotes(word) +
                 ", which is not a vertex number";
        });
      soup_.corners.push_back(from_zero(index.value_or(1), f));
    }
    soup_.end_face();
    const std::size_t n = soup_.corners.size() - begin;
    if (n < 3)
      short_faces_.add([&] { return soup_.source.at_face(f) + " has " + counted(n, "corner"); });
  }

  /// The index from 0 of a vertex that is counted from 1, or from −1 backwards.
  int from_zero(int index, int face) {
    if (index >= 0) return index - 1;
    const auto known = static_cast<int>(soup_.vertices.size());
    if (index < -known)
      bad_references_.add([&] {
        return soup_.source.at_face(face) + " names vertex " + std::to_string(index) +
               " from the back, but only " + counted(soup_.vertices.size(), "vertex") +
               " went before";
      });
    return index < -known ? -1 : known + index;
  }

  PolygonSoup soup_;
  Offenders bad_coordinates_{"vertex", "a vertex needs two or three numbers: v x y z"};
  Offenders bad_corners_{"corner", "a face needs vertex numbers: f 1 2 3"};
  Offenders short_faces_{"face", "a face needs at least three corners"};
  Offenders bad_references_{"corner", "a face may only name vertices of the mesh"};
};

/// What corners of faces say of texture coordinates.
class ObjTexture {
 public:
  explicit ObjTexture(std::string_view name) : name_(name) {}

  Points read(std::string_view text) {
    for (ContinuedLines lines(text); lines.next();) {
      Words words(lines.line());
      const std::string_view keyword = words.next();
      line_ = lines.number();
      if (keyword == "v") ++vertices_;
      if (keyword == "vt") read_coordinates(words);
      if (keyword == "f")
        for (std::string_view word = words.next(); !word.empty(); word = words.next())
          read_corner(word);
    }
    Points points = Points::Constant(2, static_cast<Eigen::Index>(vertices_), kNone);
    for (const auto& [vertex, coordinates] : coordinates_)
      points.col(static_cast<Eigen::Index>(vertex)) = coordinates;
    return points;
  }

 private:
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  [[noreturn]] void refuse(const std::string& what) const {
    throw Error(std::string(name_) + ":" + std::to_string(line_) + ": " + what);
  }

  void read_coordinates(Words words) {
    const auto u = parse_number(words.next()), v = parse_number(words.next());
    if (!u || !v) refuse("texture coordinates need two numbers: vt u v");
    known_.emplace_back(*u, *v);
  }

  void read_corner(std::string_view corner) {
    const std::size_t slash = corner.find('/');
    if (slash == std::string_view::npos) return;
    const std::string_view rest = corner.substr(slash + 1);
    const std::string_view number = rest.substr(0, rest.find('/'));
    if (number.empty()) return;
    const auto index = parse_integer(number);
    const int vertex = *parse_integer(corner.substr(0, slash));
    const std::size_t t = place(index.value_or(0), known_.size());
    if (t >= known_.size())
      refuse("the corner " + in_quotes(corner) +
             " names texture coordinates that did not go before");
    const auto [old, is_new] = coordinates_.emplace(place(vertex, vertices_), known_[t]);
    if (!is_new && old->second != known_[t])
      refuse("the corner " + in_quotes(corner) +
             " gives other texture coordinates to a vertex that has some; one place a vertex is "
             "needed");
  }

  /// The index from 0 of what is counted from 1, or from −1 backwards; too large where there is
  /// none.
  static std::size_t place(int number, std::size_t count) {
    const std::int64_t index = number < 0 ? static_cast<std::int64_t>(count) + number : number - 1;
    return static_cast<std::size_t>(index);
  }

  std::string_view name_;
  int line_ = 0;
  std::size_t vertices_ = 0;  ///< so far; corners may name some that come later
  std::vector<Vec2> known_;   ///< texture coordinates so far
  std::unordered_map<std::size_t, Vec2> coordinates_;  ///< by vertex
};

}  // namespace

PolygonSoup read_obj(std::string_view text, std::string name) {
  return ObjReader(std::move(name)).read(text);
}

Points read_obj_texture(std::string_view text, std::string_view name) {
  return ObjTexture(name).read(text);
}

}  // namespace foldless
