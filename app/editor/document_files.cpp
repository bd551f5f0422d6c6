// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/document_files.h"

#include <algorithm>
#include <array>
#include <exception>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <utility>

#include "app/editor/scene_document.h"
#include "app/editor/sources.h"
#include "core/exception_words.h"
#include "core/files/mesh_io.h"
#include "core/method/methods.h"
#include "core/scene/scene_io.h"
#include "render/image.h"

namespace foldless {
namespace {

std::filesystem::path full_path(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::path result = std::filesystem::absolute(path, error);
  return (error ? path : result).lexically_normal();
}

std::filesystem::path in(const std::filesystem::path& folder, const char* name) {
  return folder.empty() ? folder : folder / name;
}

}  // namespace

DocumentFiles::DocumentFiles(const Parts& parts, const std::filesystem::path& state_folder,
                             const std::function<void()>& wake)
    : draft_(parts.draft),
      view_(parts.view),
      race_(parts.race),
      messages_(parts.messages),
      recent_(in(state_folder, "recent.json")),
      import_(wake),
      texture_image_(wake),
      autosave_(in(state_folder, "autosave"), wake),
      recovery_(in(state_folder, "autosave"), wake) {
  mark_saved();
}

void DocumentFiles::update() {
  update_import();
  follow_texture();
  update_autosave();
}

void DocumentFiles::open(const std::filesystem::path& path) {
  ask_or_perform({PendingKind::open, full_path(path)});
}

void DocumentFiles::drop(const std::vector<std::filesystem::path>& paths) {
  if (paths.empty()) return;
  const auto document = std::ranges::find_if_not(paths, is_image_file);
  const auto image = std::ranges::find_if(paths, is_image_file);
  const std::size_t used = document != paths.end() && image != paths.end() ? 2 : 1;
  if (paths.size() > used)
    messages_.toast(ToastKind::notice, "One mesh or scene and one image are taken at a time; " +
                                           std::to_string(paths.size() - used) +
                                           " of the files were left out");
  if (used == 2)
    ask_or_perform({PendingKind::open, full_path(*document), false, full_path(*image)});
  else if (document == paths.end() && has_own_mesh() && !import_.is_open())
    set_texture(*image);
  else
    open(paths.front());
}

/// Nobody dresses the sample that the first window shows.
bool DocumentFiles::has_own_mesh() const {
  return !draft_.document().is_empty() && !(is_sample_ && !is_dirty());
}

void DocumentFiles::open_sample(const std::filesystem::path& path) {
  ask_or_perform({PendingKind::open, full_path(path), true});
}

void DocumentFiles::new_document() { ask_or_perform({PendingKind::new_document, {}}); }

void DocumentFiles::close() { ask_or_perform({PendingKind::close, {}}); }

void DocumentFiles::ask_or_perform(PendingAction action) {
  draft_.interrupt();
  asks_to_overwrite_ = false;
  pending_ = std::move(action);
  is_asking_ = is_dirty();
  if (!is_asking_) perform_pending();
  messages_.redraw();
}

void DocumentFiles::open_shape(Shape shape, const std::string& name) {
  draft_.interrupt();
  install(document_of(std::move(shape), name), "Open " + name);
}

void DocumentFiles::answer(Answer answer) {
  is_asking_ = false;
  messages_.redraw();
  if (!pending_) return;
  if (answer == Answer::cancel) pending_.reset();
  if (answer == Answer::discard) perform_pending();
  if (answer == Answer::save) save();
}

void DocumentFiles::perform_pending() {
  const PendingAction action = *std::exchange(pending_, std::nullopt);
  switch (action.kind) {
    case PendingKind::open: return load(action);
    case PendingKind::recover: return open_recovered();
    case PendingKind::close: autosave_.forget(); return messages_.request(Request::quit);
    case PendingKind::new_document: break;
  }
  install(empty_document(), "New");
}

void DocumentFiles::load(const PendingAction& action) {
  const std::filesystem::path& path = action.path;
  if (is_image_file(path)) return import_.open(path);
  try {
    if (is_mesh_file(path))
      open_mesh(path);
    else
      open_scene(path);
    if (!action.texture.empty()) set_texture(action.texture);
    is_sample_ = action.is_sample;
    if (is_sample_)
      file_.leave();
    else
      recent_.add(path);
  } catch (const std::exception& failure) {
    messages_.toast(ToastKind::error, words_of_exception(failure, path));
    std::error_code error;
    if (!std::filesystem::exists(path, error)) recent_.remove(path);
  }
}

void DocumentFiles::open_mesh(const std::filesystem::path& path) {
  LoadedMesh mesh = read_mesh(path);
  Shape shape{std::move(mesh.triangles), std::move(mesh.points)};
  Document document = document_of(std::move(shape), path.stem().string());
  document.mesh_file = path;
  install(document, "Open " + path.filename().string());
  for (std::string& notice : mesh.notices) messages_.toast(ToastKind::notice, std::move(notice));
}

void DocumentFiles::open_scene(const std::filesystem::path& path) {
  const std::optional<FileStamp> stamp = stamp_of(path);
  const auto [scene, notices] = load_scene(path, method_names());
  install(document_of(scene, path), "Open " + path.filename().string());
  if (scene.view) view_.read(*scene.view);
  take_file(path, stamp);
  for (const std::string& notice : notices) messages_.toast(ToastKind::notice, notice);
  if (scene.state) return;
  // Nothing is lost when the solver goes on from a scene without a state.
  saved_pose_ = nullptr;
  if (!is_at_targets(draft_.document())) draft_.solving().start(draft_.document());
}

void DocumentFiles::install(const Document& document, const std::string& label) {
  race_.close();
  close_import();
  recovery_.close();
  if (document.texture.empty() != draft_.document().texture.empty())
    view_.show_mesh(document.texture.empty());
  try {
    draft_.install(document, label);
    view_.fit_all();
  } catch (...) {
    // What is there now never replaces the file of what was there.
    if (draft_.document().original == document.original) file_.leave();
    throw;
  }
  file_.leave();
  is_sample_ = asks_to_overwrite_ = false;
  mark_saved();
}

void DocumentFiles::take_file(const std::filesystem::path& file,
                              const std::optional<FileStamp>& stamp) {
  file_.take(file, stamp);
  if (file_.is_shared())
    messages_.toast(ToastKind::notice,
                    file.filename().string() +
                        " is open in another Foldless too; who saves second is asked before the "
                        "work of the first is replaced");
}

void DocumentFiles::mark_saved() {
  draft_.seal();
  autosave_.forget();
  saved_step_ = draft_.history().current_id();
  saved_pose_ = draft_.document().pose;
}

bool DocumentFiles::is_dirty() const {
  if (draft_.document().is_empty() && draft_.history().steps().size() == 1) return false;
  return draft_.history().current_id() != saved_step_ ||
         (saved_pose_ && saved_pose_ != draft_.document().pose);
}

void DocumentFiles::save() {
  if (draft_.document().is_empty()) return;
  if (path().empty()) return messages_.request(Request::save_dialog);
  asks_to_overwrite_ = file_.has_changed();
  if (asks_to_overwrite_) return messages_.redraw();
  save_as(path());
}

void DocumentFiles::answer_overwrite(OverwriteAnswer answer) {
  if (!std::exchange(asks_to_overwrite_, false)) return;
  messages_.redraw();
  if (answer == OverwriteAnswer::overwrite) save_as(path());
  if (answer == OverwriteAnswer::save_as) messages_.request(Request::save_dialog);
  if (answer == OverwriteAnswer::cancel) pending_.reset();
}

bool DocumentFiles::save_as(const std::filesystem::path& path) {
  if (draft_.document().is_empty()) return false;
  const std::string problem = try_save_as(path);
  if (problem.empty()) return true;
  pending_.reset();
  messages_.toast(ToastKind::error, problem);
  return false;
}

std::string DocumentFiles::try_save_as(const std::filesystem::path& path) {
  draft_.interrupt();
  if (draft_.document().is_empty()) return "There is nothing to save.";
  std::filesystem::path file = full_path(path);
  if (file.extension().empty()) file += ".json";
  try {
    expect_no_source(draft_.document(), file);
    auto view = std::make_shared<const nlohmann::json>(view_.json());
    save_scene(scene_of(draft_.document(), file, std::move(view)), file);
  } catch (const std::exception& failure) {
    return words_of_exception(failure, file);
  }
  file_.take(file, stamp_of(file));
  mark_saved();
  recent_.add(file);
  messages_.toast(
      ToastKind::notice,
      "Saved " + file.filename().string() +
          (draft_.is_ahead_of_document() ? " with the last valid map, not the folded one" : ""));
  if (pending_ && !is_asking_) perform_pending();
  return {};
}

std::string DocumentFiles::title() const {
  const std::string name = path().empty() ? draft_.document().name : path().filename().string();
  return (is_dirty() ? "\u25cf " : "") + (name.empty() ? "Untitled" : name);
}

void DocumentFiles::set_texture(const std::filesystem::path& path) {
  draft_.interrupt();
  if (draft_.document().is_empty())
    return messages_.toast(ToastKind::error,
                           "Open a mesh or an image first: then its texture can be chosen");
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    return messages_.toast(ToastKind::error,
                           path.string() + ": there is no such file; choose another image");
  Document document = draft_.document();
  document.texture = full_path(path);
  draft_.edit("Texture", std::move(document), Change::appearance);
}

void DocumentFiles::clear_texture() {
  draft_.interrupt();
  if (draft_.document().texture.empty()) return;
  Document document = draft_.document();
  document.texture.clear();
  draft_.edit("Remove texture", std::move(document), Change::appearance);
}

}  // namespace foldless
