// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/judge/judge.h"

#include <gmpxx.h>

#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace judge {
namespace {

struct Direction {
  mpq_class x, y;
};

Direction between(const Point& from, const Point& to) {
  return {mpq_class(to[0]) - mpq_class(from[0]), mpq_class(to[1]) - mpq_class(from[1])};
}

int sign_of_cross(const Direction& a, const Direction& b) { return sgn(a.x * b.y - a.y * b.x); }
int sign_of_dot(const Direction& a, const Direction& b) { return sgn(a.x * b.x + a.y * b.y); }

/// The angle from `axis` to `d` is in [0, π), not in [π, 2π).
bool is_in_first_half(const Direction& axis, const Direction& d) {
  const int side = sign_of_cross(axis, d);
  return side > 0 || (side == 0 && sign_of_dot(axis, d) > 0);
}

/// The neighbours of a vertex, in counter-clockwise order of its triangles.
struct Fan {
  std::vector<int> rim;
  bool is_closed = false;
};

class Trial {
 public:
  explicit Trial(const Mesh& mesh) : mesh_(mesh), after_(mesh.points.size()) {}

  std::vector<std::string> objections() {
    look_at_triangles();
    if (objections_.empty()) look_at_edges();
    if (objections_.empty())
      for (std::size_t v = 0; v < after_.size(); ++v)
        if (!after_[v].empty()) look_at_vertex(static_cast<int>(v));
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
      const int side = sign_of_cross(between(point(a), point(b)), between(point(a), point(c)));
      if (side < 0) object("triangle ", t, " is clockwise");
      if (side == 0) object("triangle ", t, " has no area");
    }
  }

  /// Fills `after_`: seen from a vertex, the neighbour that follows another one.
  void look_at_edges() {
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& corners = mesh_.triangles[t];
        const int v = corners[k], next = corners[(k + 1) % 3], last = corners[(k + 2) % 3];
        if (!after_[static_cast<std::size_t>(v)].emplace(next, last).second)
          object("triangle ", t, " is the second on one side of the edge ", v, " ", next);
      }
  }

  Fan fan_of(const std::map<int, int>& after) const {
    std::map<int, int> before;
    for (const auto& [from, to] : after) before.emplace(to, from);
    int first = after.begin()->first;
    for (const auto& [from, to] : after)
      if (!before.contains(from)) first = from;
    Fan fan{{first}};
    for (auto at = after.find(first); at != after.end(); at = after.find(at->second)) {
      fan.is_closed = at->second == first;
      if (fan.is_closed) break;
      fan.rim.push_back(at->second);
    }
    return fan;
  }

  void look_at_vertex(int v) {
    const auto& after = after_[static_cast<std::size_t>(v)];
    const Fan fan = fan_of(after);
    const std::size_t triangles = fan.is_closed ? fan.rim.size() : fan.rim.size() - 1;
    if (triangles != after.size()) return object("the triangles of vertex ", v, " are no one fan");
    // Every triangle takes the rim on by less than π, so that no half is jumped over.
    const Direction axis = between(point(v), point(fan.rim.front()));
    int turns = 0;
    bool was_in_first_half = true;
    for (std::size_t i = 1; i <= triangles; ++i) {
      const Direction spoke = between(point(v), point(fan.rim[i % fan.rim.size()]));
      const bool is_first = is_in_first_half(axis, spoke);
      if (is_first && !was_in_first_half) ++turns;
      was_in_first_half = is_first;
    }
    if (fan.is_closed && turns != 1) object("vertex ", v, " is gone round ", turns, " times");
    if (!fan.is_closed && turns > 0) object("the angles at boundary vertex ", v, " reach 2π");
  }

  const Mesh& mesh_;
  std::vector<std::map<int, int>> after_;  ///< by vertex
  std::vector<std::string> objections_;
};

}  // namespace

std::vector<std::string> objections_to(const Mesh& mesh) { return Trial(mesh).objections(); }

Mesh read_obj(std::istream& in) {
  Mesh mesh;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string word;
    if (!(words >> word)) continue;
    if (word == "v") {
      std::string x, y;
      words >> x >> y;
      mesh.points.push_back({std::stod(x), std::stod(y)});
    } else if (word == "f") {
      std::vector<int> corners;
      while (words >> word) corners.push_back(std::stoi(word) - 1);
      if (corners.size() != 3) throw std::runtime_error("a face that is no triangle: " + line);
      mesh.triangles.push_back({corners[0], corners[1], corners[2]});
    }
  }
  return mesh;
}

}  // namespace judge
