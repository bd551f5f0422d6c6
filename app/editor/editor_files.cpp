// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cctype>
#include <exception>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <utility>

#include "app/editor/editor.h"
#include "app/editor/scene_document.h"
#include "core/files/mesh_io.h"
#include "core/method/methods.h"
#include "core/scene/scene_io.h"

namespace foldless {
namespace {

bool is_image_file(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  static constexpr std::array<std::string_view, 4> kExtensions{".png", ".jpg", ".jpeg", ".webp"};
  return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

std::filesystem::path full_path(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::path result = std::filesystem::absolute(path, error);
  return (error ? path : result).lexically_normal();
}

std::vector<std::string_view> method_names() {
  std::vector<std::string_view> names;
  for (const MethodRow& row : methods()) names.push_back(row.name);
  return names;
}

}  // namespace

void Editor::open(const std::filesystem::path& path) {
  ask_or_perform({PendingKind::open, full_path(path)});
}

void Editor::drop(const std::filesystem::path& path) {
  if (is_image_file(path) && !document_.is_empty() && !import_.is_open()) return set_texture(path);
  open(path);
}

void Editor::open_sample(const std::filesystem::path& path) {
  ask_or_perform({PendingKind::open, full_path(path), true});
}

void Editor::new_document() { ask_or_perform({PendingKind::new_document, {}}); }

void Editor::close() { ask_or_perform({PendingKind::close, {}}); }

void Editor::ask_or_perform(PendingAction action) {
  cancel_gesture();
  pending_ = std::move(action);
  is_asking_ = is_dirty();
  if (!is_asking_) perform_pending();
  redraw();
}

void Editor::open_shape(Shape shape, const std::string& name) {
  cancel_gesture();
  install(document_of(std::move(shape), name), "Open " + name);
  path_.clear();
  mark_saved();
}

void Editor::answer(Answer answer) {
  is_asking_ = false;
  redraw();
  if (!pending_) return;
  if (answer == Answer::cancel) pending_.reset();
  if (answer == Answer::discard) perform_pending();
  if (answer == Answer::save) save();
}

void Editor::perform_pending() {
  const PendingAction action = *std::exchange(pending_, std::nullopt);
  switch (action.kind) {
    case PendingKind::open: return load(action);
    case PendingKind::close: return request(Request::quit);
    case PendingKind::new_document: break;
  }
  install(empty_document(), "New");
  path_.clear();
  mark_saved();
}

void Editor::load(const PendingAction& action) {
  const std::filesystem::path& path = action.path;
  if (is_image_file(path)) return import_.open(path);
  try {
    if (is_mesh_file(path)) {
      LoadedMesh mesh = read_mesh(path);
      install(document_of(Shape{std::move(mesh.triangles), std::move(mesh.points)},
                          path.stem().string()),
              "Open " + path.filename().string());
      path_.clear();
      mark_saved();
      for (std::string& notice : mesh.notices) toast(ToastKind::notice, std::move(notice));
    } else {
      open_scene(path);
    }
    if (action.is_sample)
      path_.clear();
    else
      recent_.add(path);
  } catch (const std::exception& failure) {
    toast(ToastKind::error, failure.what());
    std::error_code error;
    if (!std::filesystem::exists(path, error)) recent_.remove(path);
  }
}

void Editor::open_scene(const std::filesystem::path& path) {
  const auto [scene, notices] = load_scene(path, method_names());
  install(document_of(scene, path), "Open " + path.filename().string());
  if (scene.view) needs_fit_ = !read_view(*scene.view, canvas_.camera, view_) && needs_fit_;
  path_ = path;
  mark_saved();
  for (const std::string& notice : notices) toast(ToastKind::notice, notice);
  if (scene.state) return;
  // Nothing is lost when the solver goes on from a scene without a state.
  saved_pose_ = nullptr;
  if (!is_at_targets(document_)) solving_.start(document_);
}

void Editor::install(const Document& document, std::string label) {
  history_.reset(std::move(label), document);
  last_change_.reset();
  selection_.clear();
  hovered_.reset();
  race_.close();
  close_import();
  if (document.texture.empty() != document_.texture.empty()) show_mesh(document.texture.empty());
  restore(document);
  fit_all();
}

void Editor::mark_saved() {
  last_change_.reset();
  saved_step_ = history_.current_id();
  saved_pose_ = document_.pose;
}

bool Editor::is_dirty() const {
  if (document_.is_empty() && history_.steps().size() == 1) return false;
  return history_.current_id() != saved_step_ || (saved_pose_ && saved_pose_ != document_.pose);
}

void Editor::save() {
  if (document_.is_empty()) return;
  if (path_.empty()) return request(Request::save_dialog);
  save_as(path_);
}

bool Editor::save_as(const std::filesystem::path& path) {
  cancel_gesture();
  if (document_.is_empty()) return false;
  std::filesystem::path file = full_path(path);
  if (file.extension().empty()) file += ".json";
  try {
    auto view = std::make_shared<const nlohmann::json>(view_json(canvas_.camera, view_));
    save_scene(scene_of(document_, file, std::move(view)), file);
  } catch (const std::exception& failure) {
    pending_.reset();
    toast(ToastKind::error, failure.what());
    return false;
  }
  path_ = file;
  history_.refresh(document_);
  mark_saved();
  recent_.add(file);
  toast(ToastKind::notice, "Saved " + file.filename().string() +
                               (folded_ ? " with the last valid map, not the folded one" : ""));
  if (pending_ && !is_asking_) perform_pending();
  return true;
}

void Editor::set_texture(const std::filesystem::path& path) {
  cancel_gesture();
  if (document_.is_empty())
    return toast(ToastKind::error, "Open a mesh or an image first: then its texture can be chosen");
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    return toast(ToastKind::error, path.string() + ": there is no such file; choose another image");
  Document document = document_;
  document.texture = full_path(path);
  edit("Texture", std::move(document), Change::appearance);
}

void Editor::clear_texture() {
  cancel_gesture();
  if (document_.texture.empty()) return;
  Document document = document_;
  document.texture.clear();
  edit("Remove texture", std::move(document), Change::appearance);
}

}  // namespace foldless
