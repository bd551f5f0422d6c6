// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/ui.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/gui/appearance.h"
#include "app/gui/background_exports.h"
#include "app/gui/canvas_input.h"
#include "app/gui/canvas_overlay.h"
#include "app/gui/dialog_keys.h"
#include "app/gui/export_job.h"
#include "app/gui/input_feed.h"
#include "app/gui/interface_picture.h"
#include "app/gui/names_on_screen.h"
#include "app/gui/news.h"
#include "app/gui/panels.h"
#include "app/gui/preview.h"
#include "app/gui/race_layout.h"
#include "app/gui/remembered.h"
#include "app/gui/requests.h"
#include "app/gui/scenes.h"
#include "app/gui/settings_keeper.h"
#include "app/gui/start_screen.h"
#include "app/gui/thumbnails.h"
#include "app/gui/tooltips.h"
#include "app/gui/ui_state.h"
#include "render/ui_renderer.h"

namespace foldless {
namespace {

/// ImGui lays out what it met for the first time one frame later, and popups two.
constexpr int kSettlingFrames = 3;
constexpr double kLookSeconds = 0.03;   ///< between looks at files read and written
constexpr double kPortalSeconds = 0.1;  ///< between looks at what the desktop says

/// The user's choice; until there is one, drawings are posed and meshes are studied.
Workspace workspace_for(const Settings& settings, const Editor& editor) {
  const bool is_drawing = !editor.document().texture.empty();
  return settings.workspace.value_or(is_drawing ? Workspace::animate : Workspace::lab);
}

/// Makes the context before, and destroys it after, whatever uses it.
struct ImGuiOwner {
  ImGuiOwner() { ImGui::CreateContext(); }
  ~ImGuiOwner() { ImGui::DestroyContext(); }
  ImGuiOwner(const ImGuiOwner&) = delete;
  ImGuiOwner& operator=(const ImGuiOwner&) = delete;
};

}  // namespace

struct Ui::Parts {
  explicit Parts(UiOptions given) : options(std::move(given)) {}

  UiOptions options;
  ImGuiOwner imgui;
  UiRenderer ui_renderer;
  Scenes scenes;
  InterfacePicture interface_picture;
  BackgroundExports exports;
  Thumbnails thumbnails;
  bool has_thumbnails_to_make = false;
  InputFeed feed;
  CanvasInput canvas_input;
  UiState state;
  SettingsKeeper settings_keeper{options.state_folder};
  Tooltips tooltips;
  Appearance appearance{ui_renderer, tooltips};
  Layout layout;
  std::string clipboard;  ///< keeps the text alive that ImGui was given
  double time = 0;
  int settling = kSettlingFrames;
  News news;                   ///< of the last frame
  bool has_new_look = true;    ///< fonts or colours of its own were made anew
  bool scale_changed = false;  ///< the canvas shrank or grew under the drawing

  void connect_clipboard();
  void follow_appearance(const Editor& editor, float content_scale);
  void follow_settings(Editor& editor);
  SidePanels panels(const Editor& editor) const;
};

void Ui::Parts::connect_clipboard() {
  ImGuiIO& io = ImGui::GetIO();
  io.ClipboardUserData = this;
  io.GetClipboardTextFn = [](void* user) {
    auto& parts = *static_cast<Parts*>(user);
    if (parts.options.clipboard) parts.clipboard = parts.options.clipboard();
    parts.appearance.glyphs().need(parts.clipboard);
    return parts.clipboard.c_str();
  };
  io.SetClipboardTextFn = [](void* user, const char* text) {
    auto& parts = *static_cast<Parts*>(user);
    parts.clipboard = text;
    if (parts.options.set_clipboard) parts.options.set_clipboard(text);
  };
}

void Ui::Parts::follow_appearance(const Editor& editor, float content_scale) {
  need_names(appearance.glyphs(), editor, state);
  const auto change = appearance.follow(state.settings, content_scale);
  if (change == Appearance::Change::none) return;
  has_new_look = true;
  if (change == Appearance::Change::scale) scale_changed = true;
  settling = kSettlingFrames;
}

/// The start screen and a race have none.
SidePanels Ui::Parts::panels(const Editor& editor) const {
  if (!state.settings.shows_panels || editor.race().is_open() || editor.document().is_empty())
    return SidePanels::none;
  return state.workspace == Workspace::animate ? SidePanels::one : SidePanels::two;
}

void Ui::Parts::follow_settings(Editor& editor) {
  if (settings_keeper.follow(state.settings, editor.messages())) settling = kSettlingFrames;
}

Ui::Ui(UiOptions options) : parts_(std::make_unique<Parts>(std::move(options))) {
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.ConfigInputTextCursorBlink = false;  // an open text field draws nothing while nobody types
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset | ImGuiBackendFlags_HasMouseCursors;
  InputFeed::map_keys(io);
  parts_->connect_clipboard();
  parts_->state.settings = parts_->settings_keeper.load();
  parts_->state.samples = find_samples();
}

Ui::~Ui() { parts_->settings_keeper.end(); }

void Ui::restore(Editor& editor) const { bring_back(parts_->state.settings, editor); }

void Ui::receive(const UiEvent& event) {
  parts_->feed.push(event);
  if (const auto* typed = std::get_if<CharacterTyped>(&event))
    parts_->appearance.glyphs().need(typed->code_point);
  parts_->settling = kSettlingFrames;
}

bool Ui::frame(Editor& editor, const FrameSpec& spec) {
  Parts& p = *parts_;
  prepare(editor, spec);
  const Vec2 pixels{static_cast<double>(spec.framebuffer.width) / std::max(spec.window.width, 1),
                    static_cast<double>(spec.framebuffer.height) / std::max(spec.window.height, 1)};
  const auto events = p.feed.take_frame(ImGui::GetIO(), pixels);
  p.state.modifiers = p.feed.modifiers();
  ImGui::NewFrame();
  p.tooltips.begin_frame(spec.time);
  resize(editor);
  route(editor, events, spec.time);
  begin_dialog_keys(p.state.keys.is_capturing());
  editor.view().options().theme = p.state.settings.theme;
  editor.files().autosave().set_interval(p.state.settings.autosave_seconds);
  editor.update(spec.time);
  Portal* portal = p.state.settings.uses_desktop_dialogs ? p.options.portal : nullptr;
  if (p.state.browser.follow(portal)) p.settling = kSettlingFrames;
  const bool has_opened = handle_requests(editor, p.state, p.options.pictures_folder);
  if (const auto job = p.state.exporting.take_order())
    carry_out(*job, editor, {p.scenes.canvas_renderer(), p.exports, p.state.browser});
  update_exports(p.exports, editor, p.state.browser, spec.time);
  const News news = news_of(editor);
  if (has_opened || news != std::exchange(p.news, news)) p.settling = kSettlingFrames;
  const bool has_drawn = draw_frame(editor, spec);
  p.has_thumbnails_to_make = editor.document().is_empty() && p.thumbnails.update();
  remember(editor, p.state.settings);
  p.follow_settings(editor);
  if (p.tooltips.has_appeared()) p.settling = kSettlingFrames;
  p.settling = std::max(0, p.settling - 1);
  return has_drawn;
}

/// The panels need what the scenes find, the heat map's scale, and cover them.
bool Ui::draw_frame(Editor& editor, const FrameSpec& spec) {
  Parts& p = *parts_;
  const bool has_new_scenes =
      p.scenes.follow(editor, p.layout, spec.framebuffer, p.state.settings.shows_squares);
  if (has_new_scenes) p.scenes.draw();
  p.state.heat_range = p.scenes.heat_range();
  draw_panels(editor);
  ImGui::Render();
  const bool has_new_interface = p.interface_picture.follow(*ImGui::GetDrawData());
  const bool has_new_textures = p.has_thumbnails_to_make || std::exchange(p.has_new_look, false);
  if (spec.is_kept && !has_new_scenes && !has_new_interface && !has_new_textures) return false;
  if (!has_new_scenes) p.scenes.draw();
  p.ui_renderer.draw(*ImGui::GetDrawData());
  return true;
}

void Ui::draw_again() {
  parts_->scenes.draw();
  parts_->ui_renderer.draw(*ImGui::GetDrawData());
}

void Ui::prepare(const Editor& editor, const FrameSpec& spec) {
  Parts& p = *parts_;
  p.follow_appearance(editor, spec.content_scale);
  const bool has_race = editor.race().is_open();
  const float scale = p.appearance.look().scale;
  p.state.workspace = workspace_for(p.state.settings, editor);
  p.layout = layout_for(spec.framebuffer, scale, p.panels(editor), p.state.settings.panel_widths);
  if (editor.motion().is_open() && !has_race && !editor.document().is_empty())
    add_time_line(p.layout, scale, p.state.settings.time_line_height);
  if (editor.view().beside() != Beside::nothing && !has_race) split_canvas(p.layout, scale);
  const bool has_canvas = !editor.document().is_empty() && !has_race && !preview_of(editor);
  if (p.state.settings.shows_rulers && has_canvas) add_rulers(p.layout, scale);
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(spec.framebuffer.width),
                    static_cast<float>(spec.framebuffer.height)};
  io.DeltaTime = static_cast<float>(std::clamp(spec.time - p.time, 1e-4, 1.0));
  p.time = spec.time;
}

/// What a race covers keeps its size and its view.
void Ui::resize(Editor& editor) {
  Parts& p = *parts_;
  const float scale = p.appearance.look().scale;
  if (editor.race().is_open()) {
    const auto lanes = race_layout_for(p.layout.canvas, editor.race().lanes().size(), scale);
    const Rectangle& view = lanes.lanes.front().view;
    editor.race().resize(static_cast<int>(view.width), static_cast<int>(view.height), scale);
    return;
  }
  editor.view().resize(static_cast<int>(p.layout.canvas.width),
                       static_cast<int>(p.layout.canvas.height), scale);
  if (std::exchange(p.scale_changed, false)) editor.view().fit_all();
}

void Ui::route(Editor& editor, const std::vector<UiEvent>& events, double time) {
  Parts& p = *parts_;
  p.canvas_input.begin_frame(editor.race().is_open() ? Rectangle{} : p.layout.canvas);
  for (const UiEvent& event : events)
    if (const auto* input = std::get_if<InputEvent>(&event))
      p.canvas_input.route(*input, editor, p.state, time);
  p.state.pointer = p.canvas_input.pointer();
}

void Ui::draw_panels(Editor& editor) {
  Parts& p = *parts_;
  const PanelContext context{p.state, p.appearance.look(), p.layout};
  if (const auto preview = preview_of(editor)) {
    draw_preview_overlay(*preview, context);
  } else if (editor.race().is_open()) {
    draw_race_panel(editor, context);
  } else {
    if (editor.document().is_empty()) draw_start_screen(editor, p.thumbnails, context);
    draw_artboard(editor, context);
    draw_canvas_overlay(editor, context);
    draw_rulers(editor, context);
    draw_side_panes(editor, context);
    draw_stuck_card(editor, context);
  }
  draw_menu_bar(editor, context);
  draw_tool_strip(editor, context);
  draw_panel_edges(context);
  draw_side_panels(editor, context);
  draw_timeline_panel(editor, context);
  draw_status_bar(editor, context);
  draw_toasts(editor, context);
  draw_progress(p.exports, p.layout.canvas, p.appearance.look());
  draw_dialogs(editor, context);
}

std::optional<double> Ui::next_frame(const Editor& editor, double now) const {
  const bool is_late = parts_->scenes.is_uploading() || !parts_->feed.is_empty();
  if (parts_->settling > 0 || is_late) return 0.0;
  std::optional<double> next;
  if (const auto wake = editor.next_wake()) next = std::max(0.0, *wake - now);
  for (const auto& due : {parts_->settings_keeper.due(), parts_->tooltips.due()})
    if (due) next = std::max(0.0, std::min(next.value_or(*due - now), *due - now));
  if (parts_->has_thumbnails_to_make || is_exporting())
    next = std::min(next.value_or(1), kLookSeconds);
  if (parts_->state.browser.awaits_portal()) next = std::min(next.value_or(1), kPortalSeconds);
  return next;
}

bool Ui::is_exporting() const { return parts_->exports.is_busy(); }
bool Ui::is_writing_a_file() const { return parts_->exports.file.is_busy(); }

const Layout& Ui::layout() const { return parts_->layout; }

CursorShape Ui::cursor() const {
  if (ImGui::GetIO().WantTextInput && ImGui::GetMouseCursor() == ImGuiMouseCursor_TextInput)
    return CursorShape::text;
  if (ImGui::GetMouseCursor() == ImGuiMouseCursor_ResizeEW) return CursorShape::resize;
  if (ImGui::GetMouseCursor() == ImGuiMouseCursor_ResizeNS) return CursorShape::resize_height;
  return parts_->canvas_input.cursor();
}

bool Ui::wants_to_quit() const { return parts_->state.wants_to_quit; }

Settings& Ui::settings() { return parts_->state.settings; }

}  // namespace foldless
