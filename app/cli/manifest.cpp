// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/manifest.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

#include "core/error.h"
#include "core/files/atomic_file.h"
#include "core/scene/json_object.h"
#include "core/scene/json_value.h"
#include "render/png_chunks.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;

constexpr std::array kNames{"rest.obj",    "deformed.obj",   "deformed.png",
                            "report.json", "iterations.csv", kManifest};
constexpr std::string_view kInFrames = "frames/";
constexpr double kVersion = 1;
/// 2⁵³: a number of JSON above it may stand for another.
constexpr double kLargestWhole = 9007199254740992;

std::string hexadecimal(std::uint32_t number) {
  std::string text(8, '0');
  for (auto digit = text.rbegin(); digit != text.rend(); ++digit, number /= 16)
    *digit = "0123456789abcdef"[number % 16];
  return text;
}

std::uint32_t crc_in(const JsonValue& value) {
  const std::string& text = value.text();
  std::uint32_t crc = 0;
  const char* end = text.data() + text.size();
  if (std::from_chars(text.data(), end, crc, 16).ptr != end)
    value.refuse("is " + value.shown() + ", but must be a hexadecimal number");
  return crc;
}

std::uintmax_t size_in(const JsonValue& value) {
  const double bytes = value.number();
  if (!(bytes >= 0 && bytes <= kLargestWhole && std::trunc(bytes) == bytes))
    value.refuse("is " + value.shown() + ", but must be a number of bytes");
  return static_cast<std::uintmax_t>(bytes);
}

/// A name from elsewhere would let a manifest point out of its folder.
ResultFile read_entry(const JsonValue& value) {
  ResultFile entry;
  entry.name = value.at("name").text();
  if (!is_result_name(entry.name)) value.at("name").refuse("is no file that solve writes");
  entry.bytes = size_in(value.at("bytes"));
  entry.crc = crc_in(value.at("crc32"));
  return entry;
}

}  // namespace

bool is_result_name(const std::string& name) {
  if (std::ranges::find(kNames, name) != kNames.end()) return true;
  if (!name.starts_with(kInFrames)) return false;
  const fs::path frame = name.substr(kInFrames.size());
  const std::string number = frame.stem().string();
  return number.size() >= 6 && !frame.has_parent_path() &&
         std::ranges::all_of(number, [](char c) { return '0' <= c && c <= '9'; }) &&
         (frame.extension() == ".obj" || frame.extension() == ".png");
}

std::optional<ResultFile> entry_of(const fs::path& folder, const std::string& name) {
  const fs::path file = folder / name;
  if (!fs::is_regular_file(fs::symlink_status(file))) return std::nullopt;
  if (name.starts_with(kInFrames) && fs::is_symlink(fs::symlink_status(file.parent_path())))
    return std::nullopt;
  std::uintmax_t bytes = 0;
  Crc32 crc;
  read_blocks(file, [&](std::string_view block) {
    bytes += block.size();
    crc.add(block);
  });
  return ResultFile{name, bytes, crc.value()};
}

Manifest read_manifest(const fs::path& folder) {
  const fs::path file = folder / kManifest;
  if (!fs::exists(fs::symlink_status(file))) return {};
  const std::string name = file.string();
  try {
    if (fs::is_symlink(fs::symlink_status(file))) throw Error(name + ": is a symbolic link");
    const JsonNode node = parse_json(read_file(file), name);
    const JsonValue root(node, name);
    if (root.at("foldless_result").number() != kVersion)
      root.at("foldless_result").refuse("is not known to this program");
    Manifest manifest;
    for (const JsonValue& entry : root.at("files").items()) manifest.push_back(read_entry(entry));
    return manifest;
  } catch (const Error& error) {
    throw Error(std::string(error.what()) +
                "; solve did not write this file: move it away or choose another folder");
  }
}

std::string text_of(const Manifest& manifest) {
  JsonNode::Array files;
  for (const ResultFile& file : manifest)
    files.push_back({object_of(JsonMember("name", node_of(file.name)),
                               JsonMember("bytes", node_of(static_cast<double>(file.bytes))),
                               JsonMember("crc32", node_of(hexadecimal(file.crc))))});
  return json_text({object_of(JsonMember("foldless_result", node_of(kVersion)),
                              JsonMember("files", {std::move(files)}))});
}

}  // namespace foldless
