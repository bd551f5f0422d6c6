// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/messages.h"

#include <algorithm>
#include <utility>

namespace foldless {
namespace {

constexpr double kNoticeSeconds = 4;
constexpr double kErrorSeconds = 12;

}  // namespace

void Messages::tick(double now) {
  now_ = now;
  if (std::erase_if(toasts_, [now](const Toast& t) { return t.until <= now; }) > 0) redraw();
}

void Messages::request(Request request) {
  requests_.push_back(request);
  redraw();
}

std::vector<Request> Messages::take_requests() { return std::exchange(requests_, {}); }

void Messages::toast(ToastKind kind, std::string text) {
  if (log_.size() == kMostLogged) log_.erase(log_.begin());
  log_.push_back({now_, kind, text});
  std::erase_if(toasts_, [&](const Toast& t) { return t.text == text; });
  const double seconds = kind == ToastKind::error ? kErrorSeconds : kNoticeSeconds;
  toasts_.push_back({next_toast_++, kind, std::move(text), now_ + seconds});
  redraw();
}

void Messages::dismiss_toast(int id) {
  std::erase_if(toasts_, [id](const Toast& t) { return t.id == id; });
  redraw();
}

std::optional<double> Messages::next_wake() const {
  std::optional<double> next;
  for (const Toast& toast : toasts_) next = std::min(next.value_or(toast.until), toast.until);
  return next;
}

bool Messages::take_redraw() { return std::exchange(needs_redraw_, false); }

}  // namespace foldless
