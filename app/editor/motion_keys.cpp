// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/motion_keys.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace foldless {
namespace {

bool is_selected(const Selection& selection, int id) {
  return selection.ids().empty() || selection.ids().contains(id);
}

/// Keys of another animation whose handles are still there, some frames later.
void put_keys(Animation& animation, const Animation& copied, int later) {
  for (const HandleTracks& tracks : copied.tracks) {
    const auto put = [&](const auto& track, KeyedProperty property, const auto& assign) {
      for (const auto& key : track) {
        const int frame = key.frame + later;
        if (frame < 0 || frame > last_key_frame(animation.cycle)) continue;
        Handle handle;
        handle.id = tracks.handle;
        assign(handle, key.value);
        set_key(animation, handle, property, frame);
        set_easing(animation, {{tracks.handle, property, frame}}, key.easing);
      }
    };
    put(tracks.position, KeyedProperty::position, [](Handle& h, const Vec2& p) { h.target = p; });
    put(tracks.angle, KeyedProperty::angle, [](Handle& h, double a) { h.turn = Turn{a, 0}; });
    put(tracks.depth, KeyedProperty::depth, [](Handle& h, double d) { h.depth = d; });
    put(tracks.weight, KeyedProperty::weight, [](Handle& h, double w) { h.weight = w; });
  }
}

}  // namespace

void MotionKeys::change(const std::string& label, const std::function<void(Animation&)>& change) {
  draft_.interrupt();
  if (draft_.document().is_empty()) return;
  Animation changed = animation();
  change(changed);
  if (changed == animation()) return;
  Document document = draft_.document();
  document.animation = std::make_shared<const Animation>(std::move(changed));
  draft_.edit(label, std::move(document), Change::appearance);
}

void MotionKeys::toggle_records() {
  records_ = !records_;
  messages_.redraw();
}

void MotionKeys::key_what_changed(const Document& before, Document& after) {
  if (after.is_empty() || before.animation != after.animation || before.original != after.original)
    return;
  Animation changed = animation();
  const auto expected = handles_at(changed, before.handles, play_head_.moment());
  for (const Handle& handle : after.handles) {
    const auto was = std::ranges::find(expected, handle.id, &Handle::id);
    if (was == expected.end()) continue;
    for (const KeyedProperty property : kKeyedProperties) {
      const bool is_keyed = foldless::has_keys(changed, handle.id, property);
      if ((!is_keyed && !records_) || is_same(*was, handle, property)) continue;
      if (!is_keyed && play_head_.frame() > 0) set_key(changed, *was, property, 0);
      set_key(changed, handle, property, play_head_.frame());
    }
  }
  if (changed == animation()) return;
  after.animation = std::make_shared<const Animation>(std::move(changed));
  play_head_.go_to_nearest_frame();
}

void MotionKeys::key_handles() {
  const auto is_due = [this](int id, KeyedProperty property) {
    const bool is_pose = property == KeyedProperty::position || property == KeyedProperty::angle;
    return is_selected(draft_.selection(), id) &&
           (is_pose || foldless::has_keys(animation(), id, property));
  };
  key(is_due);
}

void MotionKeys::key_row(int handle, KeyedProperty property) {
  key([&](int id, KeyedProperty other) { return id == handle && other == property; });
}

void MotionKeys::key(const std::function<bool(int, KeyedProperty)>& is_due) {
  change("Key", [&](Animation& animation) {
    for (const Handle& handle :
         handles_at(animation, draft_.document().handles, play_head_.frame()))
      for (const KeyedProperty property : kKeyedProperties)
        if (is_due(handle.id, property)) set_key(animation, handle, property, play_head_.frame());
  });
}

void MotionKeys::select(const Keys& keys) {
  Keys present;
  const Keys all = keys.empty() ? Keys() : keys_of(animation());
  std::set_intersection(keys.begin(), keys.end(), all.begin(), all.end(),
                        std::inserter(present, present.end()));
  if (present == selected_) return;
  selected_ = std::move(present);
  messages_.redraw();
}

void MotionKeys::delete_selected() {
  const Keys keys = selected_;
  change(keys.size() == 1 ? "Delete key" : "Delete keys",
         [&](Animation& animation) { remove_keys(animation, keys); });
  select_none();
}

void MotionKeys::move_selected(const std::function<int(int)>& to, bool copies) {
  Keys moved = selected_;
  change(copies ? "Copy keys" : "Move keys",
         [&](Animation& animation) { moved = move_keys(animation, selected_, to, copies); });
  select(moved);
}

void MotionKeys::copy() {
  if (selected_.empty()) return;
  Keys others = keys_of(animation());
  for (const KeyPlace& key : selected_) others.erase(key);
  copied_.animation = animation();
  remove_keys(copied_.animation, others);
  copied_.first = std::ranges::min_element(selected_, {}, &KeyPlace::frame)->frame;
  messages_.redraw();
}

void MotionKeys::paste() {
  const int later = play_head_.frame() - copied_.first;
  const Animation copied = animation_of(copied_.animation, draft_.document().handles);
  change("Paste keys", [&](Animation& animation) { put_keys(animation, copied, later); });
  Keys pasted;
  for (KeyPlace key : keys_of(copied)) {
    key.frame += later;
    pasted.insert(key);
  }
  select(pasted);
}

void MotionKeys::set_easing(const Easing& easing) {
  change("Easing",
         [&](Animation& animation) { foldless::set_easing(animation, selected_, easing); });
}

void MotionKeys::set_cycle(const Cycle& cycle) {
  Cycle possible = cycle;
  possible.frames = std::clamp(cycle.frames, 1, kMostFrames);
  change("Length of the animation",
         [&](Animation& animation) { foldless::set_cycle(animation, possible); });
}

void MotionKeys::set_fps(double fps) {
  change("Frames a second",
         [&](Animation& animation) { animation.fps = std::clamp(fps, kLeastFps, kLargestFps); });
}

bool MotionKeys::is_smooth() const {
  return std::ranges::any_of(animation().tracks, [this](const HandleTracks& tracks) {
    return tracks.is_smooth && draft_.selection().ids().contains(tracks.handle);
  });
}

void MotionKeys::toggle_smooth() {
  const bool is_smooth_now = is_smooth();
  change(is_smooth_now ? "Straight paths" : "Smooth paths", [&](Animation& animation) {
    for (HandleTracks& tracks : animation.tracks)
      if (draft_.selection().ids().contains(tracks.handle)) tracks.is_smooth = !is_smooth_now;
  });
}

bool MotionKeys::swings() const {
  return std::ranges::any_of(animation().groups, [this](const TurningGroup& group) {
    return std::ranges::any_of(group.handles,
                               [this](int id) { return draft_.selection().ids().contains(id); });
  });
}

void MotionKeys::toggle_swing() {
  const std::vector<int> order = draft_.selection().order();
  const bool ends = swings();
  if (order.empty() || (!ends && order.size() < 2)) return;
  const auto handles = handles_at(animation(), draft_.document().handles, play_head_.frame());
  const auto centre = std::ranges::find(handles, order.back(), &Handle::id);
  change(ends ? "Swing no more" : "Swing about a handle", [&](Animation& animation) {
    for (TurningGroup& group : animation.groups)
      std::erase_if(group.handles, [&](int id) { return draft_.selection().ids().contains(id); });
    std::erase_if(animation.groups, [](const TurningGroup& g) { return g.handles.empty(); });
    if (!ends) animation.groups.push_back({centre->target, {order.begin(), order.end() - 1}});
  });
}

}  // namespace foldless
