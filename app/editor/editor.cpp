// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/editor.h"

#include <algorithm>
#include <utility>

namespace foldless {
namespace {

constexpr double kNoticeSeconds = 4;
constexpr double kErrorSeconds = 12;

std::filesystem::path recent_file(const std::filesystem::path& folder) {
  return folder.empty() ? folder : folder / "recent.json";
}

}  // namespace

Editor::Editor(EditorOptions options)
    : options_(std::move(options)),
      document_(empty_document()),
      history_(options_.history_bytes),
      solving_(options_.wake),
      tool_(make_idle_tool()),
      import_(options_.wake),
      texture_image_(options_.wake),
      race_(options_.wake),
      recent_(recent_file(options_.state_folder)) {
  mark_saved();
}

Editor::~Editor() = default;

void Editor::resize(int width, int height, double ui_scale) {
  if (width == canvas_.width && height == canvas_.height && ui_scale == canvas_.ui_scale) return;
  canvas_.width = std::max(width, 1);
  canvas_.height = std::max(height, 1);
  canvas_.ui_scale = ui_scale;
  view_.ui_scale = ui_scale;
  remesh_diff_.resize(canvas_);
  if (needs_fit_) fit_all();
  redraw();
}

bool Editor::update(double now) {
  now_ = now;
  if (std::erase_if(toasts_, [now](const Toast& t) { return t.until <= now; }) > 0) redraw();
  if (std::exchange(targets_moved_, false)) solving_.move_targets(document_);
  if (solving_.poll()) {
    take_newest();
    redraw();
  }
  update_import();
  follow_texture();
  if (race_.update(now)) redraw();
  const bool rests =
      !solving_.is_running() && !is_editing() && !scrubbed_ && !race_.is_open() && !proof_.folds();
  if (stuck_.follow(document_, rests)) redraw();
  return std::exchange(needs_redraw_, false);
}

std::optional<double> Editor::next_wake() const {
  std::optional<double> next = race_.next_wake();
  for (const Toast& toast : toasts_) next = std::min(next.value_or(toast.until), toast.until);
  return next;
}

void Editor::take_newest() {
  document_.standing = solving_.standing();
  const auto& newest = solving_.newest();
  if (!newest || newest == taken_) return;
  taken_ = newest;
  const auto pose = adopted_pose(newest, *document_.pose);
  folded_ = pose->is_valid() ? nullptr : pose;
  if (pose->is_valid()) document_.pose = pose;
  refresh_shown();
}

void Editor::refresh_shown() {
  redraw();
  const auto& newest = folded_ ? folded_ : document_.pose;
  if (document_.is_empty()) {
    shown_ = nullptr;
  } else if (old_pose_) {
    shown_ = old_pose_;
  } else if (newest->handles == document_.handles) {
    shown_ = newest;
  } else {
    auto with_handles = std::make_shared<Snapshot>(*newest);
    with_handles->handles = document_.handles;
    shown_ = std::move(with_handles);
  }
  refresh_proof();
}

void Editor::refresh_proof() {
  const auto pose = old_pose_ ? old_pose_ : folded_ ? folded_ : document_.pose;
  if (pose == proved_) return;
  proved_ = pose;
  proof_ = pose ? proof_of(*pose) : Proof{};
}

ViewOptions Editor::shown_view() const {
  ViewOptions view = view_;
  view.layers.remeshed = view.layers.remeshed || remesh_diff_.is_shown();
  if (overlays_hidden_) {
    const bool fill = view.layers.fill;
    view.layers = {};
    for (const LayerRow& row : kLayerRows) view.layers.*row.shown = false;
    view.layers.fill = fill;
  }
  return view;
}

std::vector<HandleView> Editor::handle_views() const {
  std::vector<HandleView> views;
  if (!shown_) return views;
  const double tolerance = target_tolerance(document_);
  for (const Handle& handle : shown_->handles) {
    HandleView view{handle.id, handle.vertex, handle.kind};
    view.position = shown_->deformed.col(handle.vertex);
    view.target = handle.target;
    view.residual = (view.target - view.position).norm();
    view.is_at_target = view.residual <= tolerance;
    view.is_selected = selection_.contains(handle.id);
    view.is_hovered = hovered_ == handle.id;
    views.push_back(view);
  }
  return views;
}

std::string Editor::title() const {
  const std::string name = path_.empty() ? document_.name : path_.filename().string();
  return (is_dirty() ? "\u25cf " : "") + (name.empty() ? "Untitled" : name);
}

bool Editor::run_command(std::string_view name) {
  const Command* command = find_command(name);
  if (!command || !is_available(*command, *this)) return false;
  command->run(*this);
  redraw();
  return true;
}

void Editor::request(Request request) {
  requests_.push_back(request);
  redraw();
}

std::vector<Request> Editor::take_requests() { return std::exchange(requests_, {}); }

void Editor::toast(ToastKind kind, std::string text) {
  std::erase_if(toasts_, [&](const Toast& t) { return t.text == text; });
  const double seconds = kind == ToastKind::error ? kErrorSeconds : kNoticeSeconds;
  toasts_.push_back({next_toast_++, kind, std::move(text), now_ + seconds});
  redraw();
}

void Editor::dismiss_toast(int id) {
  std::erase_if(toasts_, [id](const Toast& t) { return t.id == id; });
  redraw();
}

}  // namespace foldless
