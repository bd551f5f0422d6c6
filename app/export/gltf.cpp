// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/gltf.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/error.h"

namespace foldless {
namespace {

using nlohmann::json;

// Numbers that the format gives to kinds of data.
constexpr int kUnsignedInt = 5125, kFloat = 5126;
constexpr int kVertexBuffer = 34962, kIndexBuffer = 34963;
constexpr int kNearest = 9728, kLinear = 9729, kLinearMipmaps = 9987;
constexpr int kClampToEdge = 33071, kRepeat = 10497;

using Floats = Eigen::MatrixXf;  ///< one vertex a column

Floats in_space(const Points& points, double z) {
  Floats result(3, points.cols());
  result.topRows(2) = points.cast<float>();
  result.row(2).setConstant(static_cast<float>(z));
  return result;
}

/// The difference of a frame to the first.
Floats difference(const BakedAnimation& animation, std::size_t frame) {
  const Points first = animation.frames.front().deformed.cast<float>().cast<double>();
  return in_space(animation.frames[frame].deformed - first, 0);
}

/// The bytes that a file refers to, and how.
class Buffers {
 public:
  /// Returns the number of the view. `target` 0: none.
  int add_view(const void* bytes, std::size_t count, int target) {
    while (bytes_.size() % 4 != 0) bytes_ += '\0';
    json view{{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", count}};
    if (target != 0) view["target"] = target;
    bytes_.append(static_cast<const char*>(bytes), count);
    views_.push_back(std::move(view));
    return static_cast<int>(views_.size()) - 1;
  }

  /// Returns the number of the accessor: vectors of floats, one a column.
  int add_floats(const Floats& values, bool is_of_vertices, bool has_bounds) {
    constexpr std::array kTypes{"SCALAR", "VEC2", "VEC3"};
    json accessor{
        {"bufferView", add_view(values.data(), 4 * static_cast<std::size_t>(values.size()),
                                is_of_vertices ? kVertexBuffer : 0)},
        {"componentType", kFloat},
        {"count", values.cols()},
        {"type", kTypes[static_cast<std::size_t>(values.rows() - 1)]}};
    if (has_bounds) {
      const Eigen::VectorXf least = values.rowwise().minCoeff(), most = values.rowwise().maxCoeff();
      accessor["min"] = std::vector<float>(least.begin(), least.end());
      accessor["max"] = std::vector<float>(most.begin(), most.end());
    }
    accessors_.push_back(std::move(accessor));
    return static_cast<int>(accessors_.size()) - 1;
  }

  int add_indices(const std::vector<std::uint32_t>& indices) {
    accessors_.push_back(
        {{"bufferView", add_view(indices.data(), 4 * indices.size(), kIndexBuffer)},
         {"componentType", kUnsignedInt},
         {"count", indices.size()},
         {"type", "SCALAR"}});
    return static_cast<int>(accessors_.size()) - 1;
  }

  /// The file: a header, a chunk of JSON, a chunk of bytes.
  std::string file(json document) && {
    while (bytes_.size() % 4 != 0) bytes_ += '\0';
    document["buffers"] = json::array({{{"byteLength", bytes_.size()}}});
    document["bufferViews"] = std::move(views_);
    document["accessors"] = std::move(accessors_);
    std::string text = document.dump();
    while (text.size() % 4 != 0) text += ' ';
    const std::size_t size = 12 + 8 + text.size() + 8 + bytes_.size();
    if (size > std::numeric_limits<std::uint32_t>::max())
      throw Error("a .glb file is at most 4 GiB: take fewer frames");
    std::string file = "glTF";
    append(file, 2);
    append(file, size);
    append(file, text.size());
    file.append("JSON").append(text);
    append(file, bytes_.size());
    file.append("BIN\0", 4).append(bytes_);
    return file;
  }

 private:
  static void append(std::string& file, std::size_t value) {
    for (int shift = 0; shift < 32; shift += 8) file += static_cast<char>(value >> shift & 0xFF);
  }

  std::string bytes_;
  json views_ = json::array(), accessors_ = json::array();
};

// The format is little-endian, and so is what is copied.
static_assert(std::endian::native == std::endian::little);

/// To a list of the document. (Where memory is short for a list that takes the place of null, the
/// library ends the program.)
void add_to(json& document, const char* list, json entry) {
  if (!document.contains(list)) document[list] = json::array();
  document[list].push_back(std::move(entry));
}

/// What a piece looks like: its number is that of its picture, of how that is read, and so on.
void add_material(json& document, Buffers& buffers, const GltfPiece& piece, std::size_t number) {
  const std::string png = encode_png(piece.image);
  add_to(document, "images",
         {{"bufferView", buffers.add_view(png.data(), png.size(), 0)}, {"mimeType", "image/png"}});
  const int wrap = piece.is_tiled ? kRepeat : kClampToEdge;
  add_to(document, "samplers",
         {{"magFilter", piece.is_tiled ? kNearest : kLinear},
          {"minFilter", piece.is_tiled ? kNearest : kLinearMipmaps},
          {"wrapS", wrap},
          {"wrapT", wrap}});
  add_to(document, "textures", {{"source", number}, {"sampler", number}});
  add_to(
      document, "materials",
      {{"pbrMetallicRoughness",
        {{"baseColorTexture", {{"index", number}}}, {"metallicFactor", 0}, {"roughnessFactor", 1}}},
       {"alphaMode", piece.is_tiled ? "OPAQUE" : "BLEND"},
       {"doubleSided", true},
       {"extensions", {{"KHR_materials_unlit", json::object()}}}});
}

/// Where the picture is on each vertex; v from the top.
Floats texture_coordinates(const Points& rest, const Box& place) {
  Floats result(2, rest.cols());
  const double width = place.max.x - place.min.x, height = place.max.y - place.min.y;
  for (Eigen::Index v = 0; v < rest.cols(); ++v) {
    result(0, v) = static_cast<float>((rest(0, v) - place.min.x) / width);
    result(1, v) = static_cast<float>((place.max.y - rest(1, v)) / height);
  }
  return result;
}

std::vector<std::uint32_t> corners_of(const BakedAnimation& animation, const GltfPiece& piece) {
  std::vector<std::uint32_t> corners;
  for (const int t : piece.triangles)
    for (const int v : animation.triangles.col(t)) corners.push_back(static_cast<std::uint32_t>(v));
  return corners;
}

/// Each frame has a weight of its own, which is 1 at its time and 0 at the others'. One that is
/// held has its weight once more, as late before the next as single precision has a time.
json animation_of_weights(const BakedAnimation& animation, const HeldSteps& held,
                          Buffers& buffers) {
  const std::size_t count = animation.frames.size(), ends = count + (animation.loops ? 1 : 0);
  const double start = animation.frames.front().frame;
  const auto time_of = [&](std::size_t key) {
    const double moment = key < count ? animation.frames[key].frame : animation.cycle_frames;
    return static_cast<float>((moment - start) / animation.fps);
  };
  std::vector<std::pair<float, std::size_t>> keys;  // When, and which frame.
  for (std::size_t k = 0; k < ends; ++k) {
    keys.emplace_back(time_of(k), k % count);
    if (!held.contains(k) || k + 1 >= ends) continue;
    const float late = std::nextafter(time_of(k + 1), 0.0F);
    if (late > time_of(k)) keys.emplace_back(late, k % count);
  }
  const auto size = static_cast<Eigen::Index>(keys.size());
  const auto targets = static_cast<Eigen::Index>(count) - 1;
  Floats times(1, size), weights = Floats::Zero(1, size * targets);
  for (Eigen::Index k = 0; k < size; ++k) {
    const auto [time, frame] = keys[static_cast<std::size_t>(k)];
    times(0, k) = time;
    if (frame > 0) weights(0, k * targets + static_cast<Eigen::Index>(frame) - 1) = 1;
  }
  const int input = buffers.add_floats(times, false, true);
  const int output = buffers.add_floats(weights, false, false);
  return {{"samplers",
           json::array({{{"input", input}, {"output", output}, {"interpolation", "LINEAR"}}})},
          {"channels",
           json::array({{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}})}};
}

}  // namespace

std::string gltf_binary(const BakedAnimation& animation, const std::vector<GltfPiece>& pieces,
                        const HeldSteps& held) {
  Buffers buffers;
  json document{{"asset", {{"version", "2.0"}, {"generator", "Foldless"}}},
                {"extensionsUsed", {"KHR_materials_unlit"}},
                {"scene", 0},
                {"scenes", json::array({{{"nodes", {0}}}})},
                {"nodes", json::array({{{"mesh", 0}}})}};
  json targets = json::array();
  for (std::size_t i = 1; i < animation.frames.size(); ++i)
    targets.push_back({{"POSITION", buffers.add_floats(difference(animation, i), true, true)}});
  json primitives = json::array();
  for (const GltfPiece& piece : pieces) {
    const Points& first = animation.frames.front().deformed;
    const int positions = buffers.add_floats(in_space(first, piece.z), true, true);
    const int places =
        buffers.add_floats(texture_coordinates(animation.rest, piece.place), true, false);
    const std::size_t number = primitives.size();
    json primitive{{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", places}}},
                   {"indices", buffers.add_indices(corners_of(animation, piece))},
                   {"material", number}};
    if (!targets.empty()) primitive["targets"] = targets;
    primitives.push_back(std::move(primitive));
    add_material(document, buffers, piece, number);
  }
  json mesh{{"primitives", std::move(primitives)}};
  if (!targets.empty()) {
    mesh["weights"] = std::vector<int>(targets.size(), 0);
    document["animations"] = json::array({animation_of_weights(animation, held, buffers)});
  }
  document["meshes"] = json::array({std::move(mesh)});
  return std::move(buffers).file(std::move(document));
}

BakedAnimation in_single_precision(const BakedAnimation& animation) {
  BakedAnimation result = animation;
  const Points first = animation.frames.front().deformed.cast<float>().cast<double>();
  for (std::size_t i = 0; i < animation.frames.size(); ++i)
    result.frames[i].deformed =
        i == 0 ? first : Points(first + difference(animation, i).topRows(2).cast<double>());
  return result;
}

}  // namespace foldless
