// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/autosave.h"
#include "app/editor/canvas_view.h"
#include "app/editor/draft.h"
#include "app/editor/image_import.h"
#include "app/editor/messages.h"
#include "app/editor/race.h"
#include "app/editor/recent_files.h"
#include "app/editor/recovery.h"
#include "app/editor/scene_file.h"
#include "app/editor/texture_image.h"

namespace foldless {

/// What waits for the question about unsaved changes.
enum class PendingKind { new_document, open, recover, close };
struct PendingAction {
  PendingKind kind = PendingKind::new_document;
  std::filesystem::path path;          ///< to open
  bool is_sample = false;              ///< to be saved elsewhere
  std::filesystem::path texture = {};  ///< for what is opened; empty: its own
};
enum class Answer { save, discard, cancel };
/// To the question whether to replace what another program wrote.
enum class OverwriteAnswer { overwrite, save_as, cancel };

/// Where a draft comes from and goes to: scene, mesh and image files, and whether it is saved.
/// Never throws on bad files: it shows a toast.
class DocumentFiles {
 public:
  /// What it works on; kept as it is.
  struct Parts {
    Draft& draft;
    CanvasView& view;
    Race& race;
    Messages& messages;
  };
  /// `state_folder` has the list of recent files and copies of unsaved work; empty: neither is
  /// kept. `wake` is called on other threads when update() has news.
  DocumentFiles(const Parts& parts, const std::filesystem::path& state_folder,
                const std::function<void()>& wake);

  /// Opens a scene or a mesh, or begins to import an image, by its extension; asks first when
  /// there are unsaved changes.
  void open(const std::filesystem::path& path);
  /// As open(), but an image becomes the texture of the mesh where there is one, unless that is a
  /// sample in which nothing was changed. Of several files the first mesh or scene is opened, with
  /// the first image as its texture; what is left over is said.
  void drop(const std::vector<std::filesystem::path>& paths);
  /// Opens a scene as a copy without a path: saving asks where to, and it is not a recent file.
  void open_sample(const std::filesystem::path& path);
  /// Opens a mesh that was made, not read; unsaved changes are dropped. Precondition: valid.
  void open_shape(Shape shape, const std::string& name);
  void new_document();
  /// The window's close button: Request::quit, or a question first.
  void close();
  const std::vector<std::filesystem::path>& recent() const { return recent_.paths(); }

  /// Asks first where another program has written the file since it was opened or saved here.
  void save();
  bool asks_to_overwrite() const { return asks_to_overwrite_; }
  /// One of the two questions waits for its answer.
  bool is_asking() const { return is_asking_ || asks_to_overwrite_; }
  void answer_overwrite(OverwriteAnswer answer);
  /// Writes a scene file; `.json` is added where the name has no extension. False when that fails.
  bool save_as(const std::filesystem::path& path);
  /// As save_as(), but returns why it failed, empty when it did not, and shows no toast of that.
  /// What waits for the file to be saved goes on waiting, so that another path can be tried.
  std::string try_save_as(const std::filesystem::path& path);
  /// Of the scene file; empty: never saved.
  const std::filesystem::path& path() const { return file_.path(); }
  bool is_dirty() const;
  /// "scene.json" or the mesh's name, with "● " in front when there is something to save.
  std::string title() const;
  /// The action that waits for an answer about unsaved changes, or null.
  const PendingAction* question() const { return is_asking_ ? &*pending_ : nullptr; }
  /// Answers the question; `cancel` also when the dialog that asks for a path was dismissed.
  void answer(Answer answer);

  // Copies of unsaved work.

  Autosave& autosave() { return autosave_; }
  const Autosave& autosave() const { return autosave_; }
  /// Writes a copy at once if anything is unsaved; for when the program is about to end. Returns
  /// why that cannot be done, empty when it can. Never throws.
  std::string rescue();
  Recovery& recovery() { return recovery_; }
  const Recovery& recovery() const { return recovery_; }
  /// Makes what is looked at the document, which is unsaved then; asks first when the present one
  /// has unsaved changes.
  void recover();

  // Images.

  /// The image that is being made a document of.
  ImageImport& image_import() { return import_; }
  const ImageImport& image_import() const { return import_; }
  /// Makes it the document, at once or as soon as its mesh is ready.
  void take_image();
  /// Leaves the document as it was.
  void close_import();

  void set_texture(const std::filesystem::path& path);
  void clear_texture();
  /// Reads the image of the texture again, which happens by itself when its file has changed.
  void reload_texture();
  /// The image of the document's texture, or null: none, or not read yet.
  const TextureImage& texture_image() const { return texture_image_; }

  /// Takes what was read meanwhile.
  void update();

 private:
  void ask_or_perform(PendingAction action);
  void perform_pending();
  void load(const PendingAction& action);
  bool has_own_mesh() const;
  void open_mesh(const std::filesystem::path& path);
  void open_scene(const std::filesystem::path& path);
  /// A new document, saved nowhere yet.
  void install(const Document& document, const std::string& label);
  void mark_saved();
  void take_file(const std::filesystem::path& file, const std::optional<FileStamp>& stamp);
  UnsavedWork unsaved_work() const;
  void update_autosave();
  void open_recovered();
  void update_import();
  void follow_texture();

  Draft& draft_;
  CanvasView& view_;
  Race& race_;
  Messages& messages_;
  RecentFiles recent_;
  SceneFile file_;
  bool is_sample_ = false;  ///< it came with the program
  bool asks_to_overwrite_ = false;
  static constexpr std::uint64_t kNeverSaved = 0;  ///< no step has this id
  std::uint64_t saved_step_ = kNeverSaved;
  std::shared_ptr<const Snapshot> saved_pose_;  ///< null: any, the file holds none
  std::optional<PendingAction> pending_;
  bool is_asking_ = false;
  ImageImport import_;
  bool takes_image_ = false;  ///< as soon as it is ready
  TextureImage texture_image_;
  double looked_at_texture_ = 0;  ///< whether its file has changed [s]
  Autosave autosave_;
  Recovery recovery_;
};

}  // namespace foldless
