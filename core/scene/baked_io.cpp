// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/baked_io.h"

#include <string_view>
#include <utility>

#include "core/error.h"
#include "core/files/atomic_file.h"
#include "core/files/text_lines.h"
#include "core/files/validate.h"
#include "core/scene/inline_mesh.h"

namespace foldless {
namespace {

constexpr std::string_view kKind = "animation";
constexpr int kVersion = 1;

void append_points(std::string& text, const Points& points) {
  text += '[';
  for (Eigen::Index v = 0; v < points.cols(); ++v) {
    text += v == 0 ? "[" : ",[";
    append_number(text, points(0, v));
    text += ',';
    append_number(text, points(1, v));
    text += ']';
  }
  text += ']';
}

void append_triangles(std::string& text, const Triangles& triangles) {
  text += '[';
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    text += t == 0 ? "[" : ",[";
    for (int k = 0; k < 3; ++k) {
      if (k > 0) text += ',';
      append_number(text, triangles(k, t));
    }
    text += ']';
  }
  text += ']';
}

template <typename Number>
void append_member(std::string& text, std::string_view key, Number value) {
  text.append(",\"").append(key).append("\":");
  append_number(text, value);
}

void append_flag(std::string& text, std::string_view key, bool value) {
  text.append(",\"").append(key).append("\":").append(value ? "true" : "false");
}

std::string_view key_of(MotionFailure::Place place) {
  switch (place) {
    case MotionFailure::Place::triangle: return "triangle";
    case MotionFailure::Place::boundary_vertex: return "boundary_vertex";
    case MotionFailure::Place::branch_vertex: break;
  }
  return "branch_vertex";
}

void append_failures(std::string& text, const std::vector<BakedFailure>& failures) {
  text += ",\"failures\":[";
  for (std::size_t i = 0; i < failures.size(); ++i) {
    text += i == 0 ? "{\"after\":" : ",{\"after\":";
    append_number(text, static_cast<int>(failures[i].from));
    append_member(text, "share", failures[i].failure.moment);
    append_member(text, key_of(failures[i].failure.place), failures[i].failure.index);
    text += '}';
  }
  text += ']';
}

/// The steps, by the frame before them, that a program should not go through but jump at their end.
void append_held(std::string& text, const std::vector<BakedFailure>& failures) {
  text += ",\"held\":[";
  for (std::size_t i = 0; i < failures.size(); ++i) {
    if (i > 0) text += ',';
    append_number(text, static_cast<int>(failures[i].from));
  }
  text += ']';
}

/// Reads one file, line by line.
class BakedReader {
 public:
  explicit BakedReader(const std::filesystem::path& file)
      : name_(file.string()), bytes_(read_file(file)), lines_(bytes_) {}

  BakedAnimation read() {
    const JsonNode header = next_line("the mesh");
    const int frames = read_header(JsonValue(header, name_));
    for (int i = 0; i < frames; ++i) {
      const JsonNode line = next_line("frame " + std::to_string(i));
      read_frame(JsonValue(line, name_));
    }
    while (lines_.next())
      if (!lines_.line().empty())
        throw Error(name_ + ":" + std::to_string(lines_.number()) + ": there is more than the " +
                    std::to_string(frames) + " frames that the first line counts");
    return std::move(animation_);
  }

 private:
  /// The value on the next line; it knows the number of the line.
  JsonNode next_line(const std::string& what) {
    if (!lines_.next()) throw Error(name_ + ": ends before " + what);
    std::string text(static_cast<std::size_t>(lines_.number() - 1), '\n');
    text.append(lines_.line());
    return parse_json(text, name_);
  }

  int read_header(const JsonValue& header) {
    header.allow_only({"foldless", "version", "fps", "cycle", "loop", "frames", "original_vertices",
                       "deviation", "proved", "failures", "held", "rest", "triangles"});
    const JsonValue kind = header.at("foldless");
    if (kind.text() != kKind) kind.refuse("is " + kind.shown() + ", but 'animation' is needed");
    const JsonValue version = header.at("version");
    if (version.integer() != kVersion)
      version.refuse("is " + version.shown() + ", but this program reads version 1");
    animation_.fps = header.at("fps").number_above_zero();
    animation_.cycle_frames = header.at("cycle").integer();
    animation_.loops = header.at("loop").boolean();
    animation_.original_vertices = header.at("original_vertices").integer();
    animation_.deviation = header.at("deviation").number();
    TriangleSoup mesh =
        read_inline_triangles(header.at("rest"), header.at("triangles"), name_, "rest: ");
    const int n = static_cast<int>(mesh.points.cols());
    check_connectivity(mesh.triangles, n, mesh.source);
    check_positions(mesh.triangles, mesh.points, mesh.source);
    animation_.triangles = std::move(mesh.triangles);
    animation_.rest = std::move(mesh.points);
    const JsonValue frames = header.at("frames");
    if (frames.integer() < 1) frames.refuse("is " + frames.shown() + ", but 1 or more is needed");
    return frames.integer();
  }

  void read_frame(const JsonValue& line) {
    line.allow_only({"frame", "deformed"});
    const JsonValue frame = line.at("frame"), deformed = line.at("deformed");
    BakedFrame& read = animation_.frames.emplace_back();
    read.frame = frame.number();
    read.deformed = deformed.points();
    const std::size_t count = animation_.frames.size();
    if (count > 1 && !(read.frame > animation_.frames[count - 2].frame))
      frame.refuse("is " + frame.shown() + ", but must be after the frame before");
    if (read.deformed.cols() != animation_.rest.cols())
      deformed.refuse("has " + std::to_string(read.deformed.cols()) + " vertices, but 'rest' has " +
                      std::to_string(animation_.rest.cols()));
  }

  const std::string name_;
  const std::string bytes_;
  TextLines lines_;
  BakedAnimation animation_;
};

}  // namespace

std::string baked_text(const BakedAnimation& animation, const std::vector<BakedFailure>& failures) {
  std::string text = "{\"foldless\":\"animation\",\"version\":1";
  append_member(text, "fps", animation.fps);
  append_member(text, "cycle", animation.cycle_frames);
  append_flag(text, "loop", animation.loops);
  append_member(text, "frames", static_cast<int>(animation.frames.size()));
  append_member(text, "original_vertices", animation.original_vertices);
  append_member(text, "deviation", animation.deviation);
  append_flag(text, "proved", failures.empty());
  append_failures(text, failures);
  append_held(text, failures);
  text += ",\"rest\":";
  append_points(text, animation.rest);
  text += ",\"triangles\":";
  append_triangles(text, animation.triangles);
  text += "}\n";
  for (const BakedFrame& frame : animation.frames) {
    text += "{\"frame\":";
    append_number(text, frame.frame);
    text += ",\"deformed\":";
    append_points(text, frame.deformed);
    text += "}\n";
  }
  return text;
}

BakedAnimation read_baked(const std::filesystem::path& file) { return BakedReader(file).read(); }

}  // namespace foldless
