// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/key_edits.h"

#include <algorithm>
#include <map>
#include <utility>

namespace foldless {
namespace {

/// Calls `act` with the track of a property.
template <typename Tracks, typename Act>
auto with_track(Tracks& tracks, KeyedProperty property, const Act& act) {
  switch (property) {
    case KeyedProperty::angle: return act(tracks.angle);
    case KeyedProperty::depth: return act(tracks.depth);
    case KeyedProperty::weight: return act(tracks.weight);
    case KeyedProperty::position: break;
  }
  return act(tracks.position);
}

/// Calls `act` with every track of an animation, its handle and its property.
template <typename A, typename Act>
void for_each_track(A& animation, const Act& act) {
  for (auto& tracks : animation.tracks)
    for (const KeyedProperty property : kKeyedProperties)
      with_track(tracks, property, [&](auto& track) { act(track, tracks.handle, property); });
}

/// The key of a frame, or where it would be.
template <typename Value>
auto place_of(Track<Value>& track, int frame) {
  return std::ranges::lower_bound(track, frame, {}, &Keyframe<Value>::frame);
}

template <typename Value>
void put(Track<Value>& track, const Keyframe<Value>& key) {
  const auto place = place_of(track, key.frame);
  if (place != track.end() && place->frame == key.frame)
    *place = key;
  else
    track.insert(place, key);
}

template <typename Value>
void put_value(Track<Value>& track, int frame, const Value& value) {
  const auto place = place_of(track, frame);
  Easing easing;
  if (place != track.end() && place->frame == frame)
    easing = place->easing;
  else if (place != track.begin())
    easing = std::prev(place)->easing;
  put(track, {frame, value, easing});
}

HandleTracks& tracks_of(Animation& animation, int handle) {
  const auto found = std::ranges::find(animation.tracks, handle, &HandleTracks::handle);
  if (found != animation.tracks.end()) return *found;
  animation.tracks.emplace_back();
  animation.tracks.back().handle = handle;
  return animation.tracks.back();
}

void drop_empty_tracks(Animation& animation) {
  std::erase_if(animation.tracks, [](const HandleTracks& tracks) {
    return tracks.position.empty() && tracks.angle.empty() && tracks.depth.empty() &&
           tracks.weight.empty();
  });
}

}  // namespace

Keys keys_of(const Animation& animation) {
  Keys keys;
  for_each_track(animation, [&](const auto& track, int handle, KeyedProperty property) {
    for (const auto& key : track) keys.insert({handle, property, key.frame});
  });
  return keys;
}

int last_key_frame(const Cycle& cycle) { return cycle.loops ? cycle.frames : cycle.frames - 1; }

bool has_keys(const Animation& animation, int handle, KeyedProperty property) {
  const auto found = std::ranges::find(animation.tracks, handle, &HandleTracks::handle);
  return found != animation.tracks.end() &&
         with_track(*found, property, [](const auto& track) { return !track.empty(); });
}

bool is_same(const Handle& a, const Handle& b, KeyedProperty property) {
  switch (property) {
    case KeyedProperty::angle: return !a.turn || !b.turn || a.turn->angle == b.turn->angle;
    case KeyedProperty::depth: return a.depth == b.depth;
    case KeyedProperty::weight: return a.weight == b.weight;
    case KeyedProperty::position: break;
  }
  return a.target == b.target;
}

void set_key(Animation& animation, const Handle& handle, KeyedProperty property, int frame) {
  HandleTracks& tracks = tracks_of(animation, handle.id);
  switch (property) {
    case KeyedProperty::position: put_value(tracks.position, frame, handle.target); break;
    case KeyedProperty::angle:
      if (handle.turn) put_value(tracks.angle, frame, handle.turn->angle);
      break;
    case KeyedProperty::depth: put_value(tracks.depth, frame, handle.depth); break;
    case KeyedProperty::weight: put_value(tracks.weight, frame, handle.weight); break;
  }
  drop_empty_tracks(animation);
}

void remove_keys(Animation& animation, const Keys& keys) {
  for_each_track(animation, [&](auto& track, int handle, KeyedProperty property) {
    std::erase_if(track, [&](const auto& key) {
      return keys.contains({handle, property, key.frame});
    });
  });
  drop_empty_tracks(animation);
}

Keys move_keys(Animation& animation, const Keys& keys, const std::function<int(int)>& to,
               bool copies) {
  const int last = last_key_frame(animation.cycle);
  Keys moved;
  for_each_track(animation, [&](auto& track, int handle, KeyedProperty property) {
    auto chosen = track;
    const auto is_chosen = [&](const auto& key) {
      return keys.contains({handle, property, key.frame});
    };
    std::erase_if(chosen, [&](const auto& key) { return !is_chosen(key); });
    if (!copies) std::erase_if(track, is_chosen);
    for (auto key : chosen) {
      key.frame = std::clamp(to(key.frame), 0, last);
      put(track, key);
      moved.insert({handle, property, key.frame});
    }
  });
  return moved;
}

void set_easing(Animation& animation, const Keys& keys, const Easing& easing) {
  for_each_track(animation, [&](auto& track, int handle, KeyedProperty property) {
    for (auto& key : track)
      if (keys.contains({handle, property, key.frame})) key.easing = easing;
  });
}

void set_cycle(Animation& animation, const Cycle& cycle) {
  animation.cycle = cycle;
  Keys late;
  for (const KeyPlace& key : keys_of(animation))
    if (key.frame > last_key_frame(cycle)) late.insert(key);
  remove_keys(animation, late);
}

}  // namespace foldless
