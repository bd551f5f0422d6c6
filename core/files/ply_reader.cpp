// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/IO/PLY.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <locale>
#include <sstream>
#include <utility>

#include "core/error.h"
#include "core/files/mesh_readers.h"
#include "core/files/ply_header.h"

namespace foldless {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Polygon = std::vector<std::size_t>;

/// Checks what CGAL's reader takes for granted, and writes the header anew so that it meets only
/// names that it should know: the first vertex and face elements with their positions and
/// corners. Everything else is there to be skipped.
class PlyReader {
 public:
  PlyReader(std::string_view bytes, std::string name) : header_(read_ply_header(bytes, name)) {
    soup_.source.name = std::move(name);
  }

  PolygonSoup read() {
    std::istringstream in(plain_header() + std::string(header_.body));
    in.imbue(std::locale::classic());
    std::vector<Point> points;
    std::vector<Polygon> polygons;
    try {
      CGAL::IO::read_PLY(in, points, polygons, CGAL::parameters::verbose(false));
    } catch (const std::exception&) {
      polygons.clear();  // a list length that no memory holds; the face is reported below
    }
    if (header_.format == "ascii") number_lines();
    check_complete("vertex", vertices_, points.size(), soup_.source.vertex_lines);
    check_complete("face", faces_, polygons.size(), soup_.source.face_lines);
    fill(points, polygons);
    return std::move(soup_);
  }

 private:
  [[noreturn]] void refuse(int line, const std::string& what) const {
    throw Error(soup_.source.name + ':' + std::to_string(line) + ": " + what);
  }

  std::string plain_header() {
    std::string text = "ply\nformat " + header_.format + " 1.0\n";
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;  // holds no bytes
      const bool is_vertex = !vertices_ && element.name.starts_with("vert");
      const bool is_face = !faces_ && element.name.starts_with("face");
      if (is_vertex) vertices_ = &element;
      if (is_face) faces_ = &element;
      text += is_vertex ? "element vertex " : is_face ? "element face " : "element skipped ";
      text += std::to_string(element.count) + '\n';
      const std::string corners = is_face ? corner_list(element) : "";
      if (is_vertex) check_coordinates(element);
      for (const PlyProperty& property : element.properties)
        text += plain_property(property, element, corners);
    }
    if (!vertices_) refuse(header_.lines, "the PLY file has no element 'vertex'");
    if (!faces_) refuse(header_.lines, "the PLY file has no element 'face'");
    return text + "end_header\n";
  }

  std::string plain_property(const PlyProperty& property, const PlyElement& element,
                             const std::string& corners) const {
    if (property.count_type.ends_with("int") || property.count_type.ends_with("32") ||
        property.count_type.starts_with("float") || property.count_type.starts_with("double"))
      refuse(element.line, "the element '" + element.name +
                               "' has a list whose length is of type " + property.count_type +
                               "; only uchar and ushort are supported");
    const bool is_coordinate =
        &element == vertices_ &&
        (property.name == "x" || property.name == "y" || property.name == "z");
    const std::string name = is_coordinate                                  ? property.name
                             : !corners.empty() && property.name == corners ? "vertex_indices"
                                                                            : "skipped";
    const std::string list = property.count_type.empty() ? "" : "list " + property.count_type + ' ';
    return "property " + list + property.type + ' ' + name + '\n';
  }

  void check_coordinates(const PlyElement& element) const {
    int found = 0;
    for (const PlyProperty& p : element.properties) {
      if (p.name != "x" && p.name != "y" && p.name != "z") continue;
      if (!p.count_type.empty() || (!p.type.starts_with("float") && !p.type.starts_with("double")))
        refuse(element.line, "the coordinate " + p.name + " of the vertices is of type " + p.type +
                                 "; float or double is needed");
      found += p.name == "x" ? 1 : p.name == "y" ? 2 : 0;
    }
    if (found != 3) refuse(element.line, "the vertices need one x and one y");
  }

  std::string corner_list(const PlyElement& element) const {
    for (const PlyProperty& p : element.properties)
      if (p.name == "vertex_indices" || p.name == "vertex_index") {
        if (p.count_type.empty() || (!p.type.starts_with("int") && !p.type.starts_with("uint")) ||
            p.type.ends_with('8') || p.type.ends_with("16"))
          refuse(element.line, "the property " + p.name + " must be a list of int or uint");
        return p.name;
      }
    refuse(element.line, "the faces have no list vertex_indices");
  }

  /// In a text file every element stands on a line of its own.
  void number_lines() {
    std::int64_t line = header_.lines + 1;
    for (const PlyElement& element : header_.elements) {
      std::vector<int>* lines = &element == vertices_ ? &soup_.source.vertex_lines
                                : &element == faces_  ? &soup_.source.face_lines
                                                      : nullptr;
      const auto longest = static_cast<std::int64_t>(header_.body.size()) + 1;
      const std::int64_t count = std::min(element.count, longest);
      for (std::int64_t i = 0; lines && i < count; ++i)
        lines->push_back(static_cast<int>(line + i));
      line += count;
    }
  }

  void check_complete(const std::string& noun, const PlyElement* element, std::size_t read,
                      const std::vector<int>& lines) const {
    const auto promised = static_cast<std::size_t>(element->count);
    if (read == promised) return;
    const std::string place = read < lines.size() ? ':' + std::to_string(lines[read]) : "";
    throw Error(soup_.source.name + place + ": " + noun + ' ' + std::to_string(read) +
                " cannot be read: the header promises " + counted(promised, noun) +
                ", but the file is cut short or has something else in its place");
  }

  void fill(const std::vector<Point>& points, const std::vector<Polygon>& polygons) {
    Offenders short_faces("face", "a face needs at least three corners");
    for (const Point& p : points) soup_.vertices.push_back({p.x(), p.y(), p.z()});
    for (const Polygon& polygon : polygons) {
      if (polygon.size() < 3)
        short_faces.add([&] {
          return soup_.source.at_face(soup_.face_count()) + " has " +
                 counted(polygon.size(), "corner");
        });
      for (const std::size_t v : polygon)
        soup_.corners.push_back(v <= kLargest ? static_cast<int>(v) : -1);
      soup_.end_face();
    }
    short_faces.refuse();
  }

  static constexpr std::size_t kLargest = std::numeric_limits<int>::max();

  PlyHeader header_;
  PolygonSoup soup_;
  const PlyElement* vertices_ = nullptr;
  const PlyElement* faces_ = nullptr;
};

}  // namespace

PolygonSoup read_ply(std::string_view bytes, std::string name) {
  return PlyReader(bytes, std::move(name)).read();
}

}  // namespace foldless
