// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/time_line_place.h"

#include <algorithm>
#include <cmath>

namespace foldless {
namespace {

// Design pixels.
constexpr float kTransportRow = 40, kRowNames = 124, kBesideFrames = 12, kFrameNumbers = 22,
                kKeyRow = 18;

/// In sight at the closest zoom.
constexpr double kFewestFrames = 4;

int last_frame_of(const Cycle& cycle) { return std::max(1, last_key_frame(cycle)); }

}  // namespace

std::vector<TimeLineRow> time_line_rows(const Animation& animation) {
  std::vector<TimeLineRow> rows;
  for (const HandleTracks& tracks : animation.tracks)
    for (const KeyedProperty property : kKeyedProperties)
      if (has_keys(animation, tracks.handle, property)) rows.push_back({tracks.handle, property});
  return rows;
}

double TimeLinePlace::moment_at(float x) const {
  const double share = static_cast<double>((x - left()) / std::max(1.0F, width()));
  return std::clamp(first + share * shown, 0.0, static_cast<double>(last));
}

int TimeLinePlace::frame_at(float x) const { return static_cast<int>(std::lround(moment_at(x))); }

int TimeLinePlace::row_at(float y) const {
  return static_cast<int>(std::floor((y - area.y - ruler) / row)) - 1 + first_row;
}

int TimeLinePlace::rows_in_sight() const {
  return std::max(1, static_cast<int>((area.height - ruler) / row) - 1);
}

TimeLinePlace time_line_place(const Rectangle& timeline, float scale, const Cycle& cycle,
                              const TimeLineView& view) {
  TimeLinePlace place;
  const float top = std::round(kTransportRow * scale);
  place.area = {timeline.x, timeline.y + top, timeline.width, timeline.height - top};
  place.labels = kRowNames * scale;
  place.margin = kBesideFrames * scale;
  place.ruler = kFrameNumbers * scale;
  place.row = kKeyRow * scale;
  place.last = last_frame_of(cycle);
  place.first_row = view.first_row;
  const TimeLineView possible = scrolled(view, 0, cycle);
  place.first = possible.first;
  place.shown = place.last / possible.zoom;
  return place;
}

TimeLineView zoomed(const TimeLineView& view, double factor, double about, const Cycle& cycle) {
  const int last = last_frame_of(cycle);
  TimeLineView result = view;
  result.zoom = std::clamp(view.zoom * factor, 1.0, std::max(1.0, last / kFewestFrames));
  result.first = about - (about - view.first) * view.zoom / result.zoom;
  return scrolled(result, 0, cycle);
}

TimeLineView scrolled(const TimeLineView& view, double by, const Cycle& cycle) {
  const int last = last_frame_of(cycle);
  TimeLineView result = view;
  result.zoom = std::clamp(view.zoom, 1.0, std::max(1.0, last / kFewestFrames));
  result.first = std::clamp(view.first + by, 0.0, last - last / result.zoom);
  return result;
}

TimeLineView with_moment_in_sight(const TimeLineView& view, double moment, const Cycle& cycle) {
  const double shown = last_frame_of(cycle) / view.zoom;
  const double nearest = std::clamp(view.first, moment - shown, moment);
  return scrolled(view, nearest - view.first, cycle);
}

}  // namespace foldless
