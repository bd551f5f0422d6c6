// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/animation_json.h"
#include "core/scene/json_object.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace foldless {
namespace {

constexpr std::string_view kSmooth = "smooth", kStraight = "straight";

Easing read_easing(const JsonValue& value) {
  if (value.node().as<std::string>()) {
    if (const auto easing = find_easing(value.text())) return *easing;
    std::vector<std::string_view> names;
    names.reserve(easings().size());
    for (const NamedEasing& row : easings()) names.push_back(row.name);
    value.refuse("is " + value.shown() + ", which is unknown; known are " + listed(names) +
                 " and [x1, y1, x2, y2]");
  }
  const std::vector<JsonValue> numbers = value.items();
  if (numbers.size() != 4)
    value.refuse("is " + value.shown() + ", but a name or [x1, y1, x2, y2] is needed");
  for (const std::size_t x : {std::size_t{0}, std::size_t{2}})
    if (!(numbers[x].number() >= 0 && numbers[x].number() <= 1))
      numbers[x].refuse("is " + numbers[x].shown() + ", but x goes from 0 to 1");
  return {{numbers[0].number(), numbers[1].number()}, {numbers[2].number(), numbers[3].number()}};
}

/// In a loop there may be a key at the end, where the first frame comes again.
int last_frame(const Cycle& cycle) { return cycle.loops ? cycle.frames : cycle.frames - 1; }

template <typename Value, typename Read>
Track<Value> read_track(const JsonValue& keys, const Cycle& cycle, const Read& read) {
  Track<Value> track;
  for (const JsonValue& item : keys.items()) {
    item.allow_only({"frame", "value", "easing"});
    const JsonValue frame = item.at("frame");
    Keyframe<Value> key{frame.integer(), read(item.at("value")), {}};
    if (key.frame < 0 || key.frame > last_frame(cycle))
      frame.refuse("is " + frame.shown() + ", but the frames are 0 to " +
                   std::to_string(last_frame(cycle)));
    if (!track.empty() && key.frame <= track.back().frame)
      frame.refuse("is " + frame.shown() + ", but the key before is at frame " +
                   std::to_string(track.back().frame));
    if (const auto easing = item.find("easing")) key.easing = read_easing(*easing);
    track.push_back(std::move(key));
  }
  return track;
}

/// A handle that is there, named for the first time.
const Handle& read_handle(const JsonValue& value, const std::vector<Handle>& handles,
                          std::set<int>& named) {
  const int id = value.integer();
  const auto handle = std::ranges::find(handles, id, &Handle::id);
  if (handle == handles.end()) value.refuse("is " + value.shown() + ", but no handle has that id");
  if (!named.insert(id).second)
    value.refuse("is " + value.shown() + ", a handle that was named before");
  return *handle;
}

bool read_is_smooth(const JsonValue& path) {
  if (path.text() != kSmooth && path.text() != kStraight)
    path.refuse("is " + path.shown() + ", but straight or smooth is needed");
  return path.text() == kSmooth;
}

HandleTracks read_tracks(const JsonValue& item, const Cycle& cycle, const Handle& handle) {
  item.allow_only({"handle", "path", "position", "angle", "depth", "weight"});
  const auto number = [](const JsonValue& value) { return value.number(); };
  HandleTracks tracks;
  tracks.handle = handle.id;
  if (const auto path = item.find("path")) tracks.is_smooth = read_is_smooth(*path);
  if (const auto keys = item.find("position"))
    tracks.position =
        read_track<Vec2>(*keys, cycle, [](const JsonValue& value) { return value.point(); });
  if (const auto keys = item.find("angle")) {
    if (!handle.turn)
      keys->refuse("moves a handle that has no 'angle' and 'radius' and so does not turn");
    tracks.angle = read_track<double>(*keys, cycle, number);
  }
  if (const auto keys = item.find("depth")) tracks.depth = read_track<double>(*keys, cycle, number);
  if (const auto keys = item.find("weight"))
    tracks.weight = read_track<double>(
        *keys, cycle, [](const JsonValue& value) { return value.number_above_zero(); });
  return tracks;
}

JsonNode value_node(double value) { return {value}; }
JsonNode value_node(const Vec2& value) {
  return {array_of(JsonNode{value.x()}, JsonNode{value.y()})};
}

JsonNode easing_node(const Easing& easing) {
  if (const std::string_view name = name_of(easing); !name.empty()) return {std::string(name)};
  JsonNode::Array numbers;
  for (const Vec2& point : {easing.first, easing.second})
    for (const double x : point) numbers.push_back({x});
  return {std::move(numbers)};
}

template <typename Value>
void add_track(JsonNode::Object& object, const char* name, const Track<Value>& track) {
  if (track.empty()) return;
  JsonNode::Array keys;
  for (const Keyframe<Value>& key : track) {
    JsonNode::Object item = object_of(JsonMember("frame", {static_cast<double>(key.frame)}),
                                      JsonMember("value", value_node(key.value)));
    if (key.easing != Easing()) item.emplace_back("easing", easing_node(key.easing));
    keys.push_back({std::move(item)});
  }
  object.emplace_back(name, JsonNode{std::move(keys)});
}

JsonNode tracks_node(const HandleTracks& tracks) {
  JsonNode::Object object = object_of(JsonMember("handle", {static_cast<double>(tracks.handle)}));
  if (tracks.is_smooth) object.emplace_back("path", JsonNode{std::string(kSmooth)});
  add_track(object, "position", tracks.position);
  add_track(object, "angle", tracks.angle);
  add_track(object, "depth", tracks.depth);
  add_track(object, "weight", tracks.weight);
  return {std::move(object)};
}

JsonNode group_node(const TurningGroup& group) {
  JsonNode::Array ids;
  for (const int id : group.handles) ids.push_back({static_cast<double>(id)});
  return {object_of(JsonMember("center", value_node(group.center)),
                    JsonMember("handles", {std::move(ids)}))};
}

}  // namespace

Animation read_animation(const JsonValue& animation, const std::vector<Handle>& handles) {
  animation.allow_only({"fps", "frames", "loop", "tracks", "groups"});
  Animation result;
  if (const auto fps = animation.find("fps")) {
    result.fps = fps->number();
    if (!(result.fps >= kLeastFps && result.fps <= kLargestFps))
      fps->refuse("is " + fps->shown() + ", but a number from 0.1 to 1000 is needed");
  }
  const JsonValue frames = animation.at("frames");
  result.cycle.frames = frames.integer();
  if (result.cycle.frames < 1 || result.cycle.frames > kMostFrames)
    frames.refuse("is " + frames.shown() + ", but a number from 1 to 100000 is needed");
  if (const auto loop = animation.find("loop")) result.cycle.loops = loop->boolean();
  std::set<int> moved, grouped;
  if (const auto tracks = animation.find("tracks"))
    for (const JsonValue& item : tracks->items())
      result.tracks.push_back(
          read_tracks(item, result.cycle, read_handle(item.at("handle"), handles, moved)));
  if (const auto groups = animation.find("groups"))
    for (const JsonValue& item : groups->items()) {
      item.allow_only({"center", "handles"});
      TurningGroup& group = result.groups.emplace_back();
      group.center = item.at("center").point();
      for (const JsonValue& id : item.at("handles").items())
        group.handles.push_back(read_handle(id, handles, grouped).id);
    }
  return result;
}

JsonNode animation_node(const Animation& animation) {
  JsonNode::Object object =
      object_of(JsonMember("fps", {animation.fps}),
                JsonMember("frames", {static_cast<double>(animation.cycle.frames)}));
  if (animation.cycle.loops) object.emplace_back("loop", JsonNode{true});
  JsonNode::Array tracks, groups;
  for (const HandleTracks& of_handle : animation.tracks) tracks.push_back(tracks_node(of_handle));
  for (const TurningGroup& group : animation.groups) groups.push_back(group_node(group));
  object.emplace_back("tracks", JsonNode{std::move(tracks)});
  if (!groups.empty()) object.emplace_back("groups", JsonNode{std::move(groups)});
  return {std::move(object)};
}

}  // namespace foldless
