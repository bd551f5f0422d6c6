// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/race.h"

#include <algorithm>
#include <string>
#include <utility>

namespace foldless {
namespace {

/// Space between what is fitted and the border of a lane. [design pixels]
constexpr double kMarginOfAPane = 18;

}  // namespace

Race::Race(std::function<void()> wake) : wake_(std::move(wake)) {}

void Race::open(Document document) {
  document_ = std::move(document);
  set_setup(method_race(*document_));
}

void Race::close() {
  lanes_.clear();
  document_.reset();
}

void Race::set_setup(RaceSetup setup) {
  setup_ = std::move(setup);
  needs_fit_ = true;
  restart();
}

void Race::restart() {
  lanes_.clear();
  const Document start = start_of_race(*document_, setup_.starts_at_rest);
  for (RaceEntry& entry : entries_of(setup_, *document_))
    lanes_.push_back(std::make_unique<RaceLane>(std::move(entry), start, wake_));
  tick_ = furthest_ = wanted_ = 0;
  is_playing_ = true;
  for (const auto& lane : lanes_) lane->run();
  if (needs_fit_) fit();
}

std::size_t Race::reached() const {
  std::size_t slowest = 0, longest = 0;
  bool is_running = false;
  for (const auto& lane : lanes_) {
    const std::size_t count = lane->records().size();
    longest = std::max(longest, count);
    if (lane->has_ended()) continue;
    slowest = is_running ? std::min(slowest, count) : count;
    is_running = true;
  }
  return is_running ? slowest : longest;
}

bool Race::update(double now) {
  if (!is_open()) return false;
  bool is_new = false;
  for (const auto& lane : lanes_) is_new = lane->poll() || is_new;
  const std::size_t before = tick_;
  const std::size_t limit = reached();
  if (is_playing_ && !pace_) {
    tick_ = std::max(tick_, limit);
  } else if (is_playing_ && tick_ < limit && now >= next_tick_) {
    ++tick_;
    const double period = 1 / *pace_;
    next_tick_ = (now - next_tick_ < period ? next_tick_ : now) + period;
  } else if (wanted_ > tick_ && limit >= wanted_) {
    tick_ = wanted_;
  }
  furthest_ = std::max(furthest_, tick_);
  for (const auto& lane : lanes_) lane->show(tick_);
  // What grew beyond the targets is seen whole in the end.
  if (tick_ != before && is_fitted_ && is_finished()) fit();
  return is_new || tick_ != before;
}

std::optional<double> Race::next_wake() const {
  if (!is_open() || !is_playing_ || !pace_ || tick_ >= reached()) return std::nullopt;
  return next_tick_;
}

bool Race::is_finished() const {
  return std::ranges::all_of(lanes_, [](const auto& lane) { return lane->is_at_end(); });
}

Status Race::status() const {
  const std::string at = ", iteration " + std::to_string(tick_);
  if (!is_finished())
    return is_playing_ ? Status{StatusKind::solving, "Race" + at}
                       : Status{StatusKind::paused, "Race paused" + at};
  const auto arrived =
      std::ranges::count_if(lanes_, [](const auto& lane) { return lane->is_at_targets(); });
  const auto all = static_cast<std::ptrdiff_t>(lanes_.size());
  return {
      arrived == all ? StatusKind::converged : StatusKind::blocked,
      "Race over: " + std::to_string(arrived) + " of " + std::to_string(all) + " lanes got there"};
}

void Race::pause() {
  is_playing_ = false;
  wanted_ = tick_;
  for (const auto& lane : lanes_) lane->pause();
}

void Race::toggle() {
  if (is_playing()) return pause();
  is_playing_ = true;
  for (const auto& lane : lanes_) lane->run();
}

void Race::step_forward() {
  pause();
  if (is_finished()) return;
  wanted_ = tick_ + 1;
  for (const auto& lane : lanes_) lane->step_from(tick_);
}

void Race::step_back() {
  if (tick_ > 0) scrub(tick_ - 1);
}

void Race::scrub(std::size_t tick) {
  pause();
  tick_ = wanted_ = std::min(tick, furthest_);
  for (const auto& lane : lanes_) lane->show(tick_);
}

void Race::resize(int width, int height, double ui_scale) {
  if (width == canvas_.width && height == canvas_.height && ui_scale == canvas_.ui_scale) return;
  canvas_.width = std::max(width, 1);
  canvas_.height = std::max(height, 1);
  canvas_.ui_scale = ui_scale;
  fit();
}

void Race::fit() {
  needs_fit_ = canvas_.width <= 1 || canvas_.height <= 1;
  if (needs_fit_ || lanes_.empty()) return;
  const Vec2 first = lanes_.front()->shown()->deformed.col(0);
  Box box{{first.x(), first.y()}, {first.x(), first.y()}};
  const auto extend = [&box](const Vec2& p) {
    box.min = {std::min(box.min.x, p.x()), std::min(box.min.y, p.y())};
    box.max = {std::max(box.max.x, p.x()), std::max(box.max.y, p.y())};
  };
  for (const auto& lane : lanes_)
    for (const auto& p : lane->shown()->deformed.colwise()) extend(p);
  for (const Handle& handle : document_->handles) extend(handle.target);
  canvas_.camera = fit_to_box(box, canvas_.size(), kMarginOfAPane * canvas_.ui_scale);
  is_fitted_ = true;
}

}  // namespace foldless
