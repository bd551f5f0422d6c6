// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/judge/judge.h"

#include <gmpxx.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <compare>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace judge {
namespace {

struct Direction {
  const Point &from, &to;

  mpq_class exact(int i) const { return mpq_class(to[i]) - mpq_class(from[i]); }
  double rounded(int i) const { return to[i] - from[i]; }
};

/// Of a sum of two products of differences. Doubles decide it where they can: a product of rounded
/// differences is rounded three times by 2⁻⁵³ of itself at most, or to a number that is below the
/// normal ones, and the sum once more. What overflows compares as false.
int sign_of_sum(double left, double right) {
  const double sum = left + right;
  const double doubt = 0x1p-50 * (std::abs(left) + std::abs(right)) + 0x1p-1000;
  return sum > doubt ? 1 : sum < -doubt ? -1 : 0;
}

int sign_of_cross(const Direction& a, const Direction& b) {
  if (const int sign = sign_of_sum(a.rounded(0) * b.rounded(1), -a.rounded(1) * b.rounded(0)))
    return sign;
  return sgn(a.exact(0) * b.exact(1) - a.exact(1) * b.exact(0));
}

int sign_of_dot(const Direction& a, const Direction& b) {
  if (const int sign = sign_of_sum(a.rounded(0) * b.rounded(0), a.rounded(1) * b.rounded(1)))
    return sign;
  return sgn(a.exact(0) * b.exact(0) + a.exact(1) * b.exact(1));
}

/// The angle from `axis` to `d` is in [0, π), not in [π, 2π).
bool is_in_first_half(const Direction& axis, const Direction& d) {
  if (&d.to == &axis.to) return true;
  const int side = sign_of_cross(axis, d);
  return side > 0 || (side == 0 && sign_of_dot(axis, d) > 0);
}

/// A corner of a triangle, and the neighbours of its vertex that follow and come before it there.
struct Corner {
  int vertex, next, last, triangle;
  auto operator<=>(const Corner&) const = default;
};

using Corners = std::span<const Corner>;

/// The neighbours of a vertex, in counter-clockwise order of its triangles.
struct Fan {
  std::vector<int> rim;
  bool is_closed = false;
};

/// Of the corners of a vertex, which are sorted and differ in `next`.
Fan fan_of(Corners corners) {
  std::vector<int> lasts;
  for (const Corner& corner : corners) lasts.push_back(corner.last);
  std::ranges::sort(lasts);
  Fan fan{{corners.front().next}};
  for (const Corner& corner : corners)
    if (!std::ranges::binary_search(lasts, corner.next)) fan.rim.front() = corner.next;
  for (int at = fan.rim.front(); !fan.is_closed;) {
    const auto found = std::ranges::lower_bound(corners, at, {}, &Corner::next);
    if (found == corners.end() || found->next != at) break;
    at = found->last;
    fan.is_closed = at == fan.rim.front();
    if (!fan.is_closed) fan.rim.push_back(at);
  }
  return fan;
}

class Trial {
 public:
  explicit Trial(const Mesh& mesh) : mesh_(mesh) {}

  std::vector<std::string> objections() {
    look_at_triangles();
    if (objections_.empty()) look_at_edges();
    if (objections_.empty()) look_at_vertices();
    return std::move(objections_);
  }

 private:
  template <typename... Words>
  void object(const Words&... words) {
    std::ostringstream sentence;
    (sentence << ... << words);
    objections_.push_back(sentence.str());
  }

  const Point& point(int v) const { return mesh_.points[static_cast<std::size_t>(v)]; }

  void look_at_triangles() {
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto [a, b, c] = mesh_.triangles[t];
      for (const int v : mesh_.triangles[t]) {
        if (v < 0 || static_cast<std::size_t>(v) >= mesh_.points.size())
          return object("triangle ", t, " names vertex ", v, ", which is not there");
        if (!std::isfinite(point(v)[0]) || !std::isfinite(point(v)[1]))
          return object("vertex ", v, " is not finite");
      }
      const int side = sign_of_cross({point(a), point(b)}, {point(a), point(c)});
      if (side < 0) object("triangle ", t, " is clockwise");
      if (side == 0) object("triangle ", t, " has no area");
    }
  }

  /// Fills `corners_`.
  void look_at_edges() {
    corners_.reserve(3 * mesh_.triangles.size());
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto [a, b, c] = mesh_.triangles[t];
      const int triangle = static_cast<int>(t);
      corners_.insert(corners_.end(),
                      {{a, b, c, triangle}, {b, c, a, triangle}, {c, a, b, triangle}});
    }
    std::ranges::sort(corners_);
    for (std::size_t i = 1; i < corners_.size(); ++i) {
      const auto& [v, next, last, triangle] = corners_[i];
      if (v == corners_[i - 1].vertex && next == corners_[i - 1].next)
        object("triangle ", triangle, " is the second on one side of the edge ", v, " ", next);
    }
  }

  void look_at_vertices() {
    for (auto begin = corners_.begin(); begin != corners_.end();) {
      const int v = begin->vertex;
      const auto end =
          std::find_if(begin, corners_.end(), [v](const Corner& c) { return c.vertex != v; });
      look_at_vertex(v, Corners(begin, end));
      begin = end;
    }
  }

  void look_at_vertex(int v, Corners corners) {
    const Fan fan = fan_of(corners);
    const std::size_t triangles = fan.is_closed ? fan.rim.size() : fan.rim.size() - 1;
    if (triangles != corners.size())
      return object("the triangles of vertex ", v, " are no one fan");
    // Every triangle takes the rim on by less than π, so that no half is jumped over.
    const Direction axis{point(v), point(fan.rim.front())};
    int turns = 0;
    bool was_in_first_half = true;
    for (std::size_t i = 1; i <= triangles; ++i) {
      const Direction spoke{point(v), point(fan.rim[i % fan.rim.size()])};
      const bool is_first = is_in_first_half(axis, spoke);
      if (is_first && !was_in_first_half) ++turns;
      was_in_first_half = is_first;
    }
    if (fan.is_closed && turns != 1) object("vertex ", v, " is gone round ", turns, " times");
    if (!fan.is_closed && turns > 0) object("the angles at boundary vertex ", v, " reach 2π");
  }

  const Mesh& mesh_;
  std::vector<Corner> corners_;
  std::vector<std::string> objections_;
};

/// Of a line, those between blanks.
class Words {
 public:
  explicit Words(const std::string& line) : line_(line), rest_(line) {}

  [[noreturn]] void refuse(const std::string& what) const {
    throw std::runtime_error(what + ": " + line_);
  }
  /// Empty after the last one.
  std::string_view next() {
    const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    const auto begin = std::find_if_not(rest_.begin(), rest_.end(), is_blank);
    const auto end = std::find_if(begin, rest_.end(), is_blank);
    rest_ = std::string_view(end, rest_.end());
    return std::string_view(begin, end);
  }
  /// That with which the next word begins.
  template <typename Number>
  Number number() {
    const std::string_view word = next();
    Number number{};
    if (std::from_chars(word.data(), word.data() + word.size(), number).ec != std::errc())
      refuse("a number that is none");
    return number;
  }

 private:
  const std::string& line_;
  std::string_view rest_;
};

}  // namespace

std::vector<std::string> objections_to(const Mesh& mesh) { return Trial(mesh).objections(); }

Mesh read_obj(std::istream& in) {
  Mesh mesh;
  for (std::string line; std::getline(in, line);) {
    Words words(line);
    const std::string_view word = words.next();
    if (word == "v") {
      const double x = words.number<double>();
      mesh.points.push_back({x, words.number<double>()});
    } else if (word == "f") {
      Triangle corners;
      for (int& corner : corners) corner = words.number<int>() - 1;
      if (!words.next().empty()) words.refuse("a face that is no triangle");
      mesh.triangles.push_back(corners);
    }
  }
  return mesh;
}

}  // namespace judge
