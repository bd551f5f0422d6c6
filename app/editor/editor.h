// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "app/editor/canvas.h"
#include "app/editor/commands.h"
#include "app/editor/document.h"
#include "app/editor/history.h"
#include "app/editor/image_import.h"
#include "app/editor/input.h"
#include "app/editor/messages.h"
#include "app/editor/parameter_rows.h"
#include "app/editor/proof.h"
#include "app/editor/race.h"
#include "app/editor/recent_files.h"
#include "app/editor/remesh_diff.h"
#include "app/editor/solving.h"
#include "app/editor/stuck.h"
#include "app/editor/texture_image.h"
#include "app/editor/tool.h"
#include "core/depth/paint_order.h"
#include "render/view_options.h"

namespace foldless {

/// What an editor needs from outside.
struct EditorOptions {
  std::filesystem::path state_folder;  ///< holds the recent files; empty: nothing is kept on disk
  std::function<void()> wake;          ///< called on the solver's thread when update() has news
  std::size_t history_bytes = std::size_t{1} << 30;
};

/// What an edit changes, as far as the solver is concerned.
enum class Change {
  appearance,  ///< nothing that it sees
  targets,     ///< targets of the same handles
  parameters,  ///< energy, method or numbers
  mesh         ///< the mesh, or which handles there are
};

/// The program without its window: a document, its history, what is selected and seen, and the
/// solver behind it. Takes plain input events, says what to draw. One thread only. Never throws on
/// bad files or refused edits: it shows a toast. An edit that comes in the middle of a gesture
/// cancels the gesture.
class Editor {
 public:
  explicit Editor(EditorOptions options = {});
  ~Editor();

  // The loop: events in, then one update a frame. `now` is a clock that never goes back. [s]

  /// Size of the canvas in framebuffer pixels and framebuffer pixels in one design pixel.
  void resize(int width, int height, double ui_scale);
  void receive(const InputEvent& event, double now);
  /// Sends the newest targets to the solver and takes its newest state. Returns whether something
  /// on screen may have changed since the last call.
  bool update(double now);
  /// When update() must be called again though nothing happens (a toast goes away), if ever. [s]
  std::optional<double> next_wake() const;

  // What to draw.

  /// The mesh on screen, or null when nothing is open: the newest state, or the chosen iteration.
  /// Its handles have the newest targets.
  const std::shared_ptr<const Snapshot>& shown() const { return shown_; }
  const Canvas& canvas() const { return canvas_; }
  /// The options to draw with: the user's, without overlays while H is held.
  ViewOptions shown_view() const;
  /// The options as the user set them; change them freely.
  ViewOptions& view() { return view_; }
  const ViewOptions& view() const { return view_; }
  std::vector<HandleView> handle_views() const;
  const std::set<int>& selection() const { return selection_; }  ///< ids
  std::optional<int> hovered() const { return hovered_; }        ///< id
  std::optional<PixelBox> band() const { return tool_->band(); }
  Status status() const;
  /// Of the mesh on screen.
  const Proof& proof() const { return proof_; }
  /// "scene.json" or the mesh's name, with "● " in front when there is something to save.
  std::string title() const;

  const Document& document() const { return document_; }
  const History& history() const { return history_; }
  /// True while a gesture changes the document.
  bool is_editing() const { return tool_->is_editing(); }

  // Commands and messages.

  /// Runs a command of the table if it is enabled; returns whether it was.
  bool run_command(std::string_view name);
  void request(Request request);
  /// What the surroundings should do, oldest first; each is given once.
  std::vector<Request> take_requests();
  void toast(ToastKind kind, std::string text);
  void dismiss_toast(int id);
  const std::vector<Toast>& toasts() const { return toasts_; }
  void redraw() { needs_redraw_ = true; }

  // Files.

  /// Opens a scene or a mesh, or begins to import an image, by its extension; asks first when
  /// there are unsaved changes.
  void open(const std::filesystem::path& path);
  /// As open(), but an image becomes the texture of the mesh where there is one.
  void drop(const std::filesystem::path& path);
  /// Opens a scene as a copy without a path: saving asks where to, and it is not a recent file.
  void open_sample(const std::filesystem::path& path);
  /// Opens a mesh that was made, not read; unsaved changes are dropped. Precondition: valid.
  void open_shape(Shape shape, const std::string& name);
  void new_document();
  /// The image that is being made a document of.
  ImageImport& image_import() { return import_; }
  const ImageImport& image_import() const { return import_; }
  /// Makes it the document, at once or as soon as its mesh is ready.
  void take_image();
  /// Leaves the document as it was.
  void close_import();
  void save();
  /// Writes a scene file; `.json` is added where the name has no extension. False when that fails.
  bool save_as(const std::filesystem::path& path);
  void set_texture(const std::filesystem::path& path);
  void clear_texture();
  /// The image of the document's texture, or null: none, or not read yet.
  const TextureImage& texture_image() const { return texture_image_; }
  /// The window's close button: Request::quit, or a question first.
  void close();
  /// Of the scene file; empty: never saved.
  const std::filesystem::path& path() const { return path_; }
  bool is_dirty() const;
  /// The action that waits for an answer about unsaved changes, or null.
  const PendingAction* question() const { return is_asking_ ? &*pending_ : nullptr; }
  /// Answers the question; `cancel` also when the dialog that asks for a path was dismissed.
  void answer(Answer answer);
  const std::vector<std::filesystem::path>& recent() const { return recent_.paths(); }

  // Edits; each is one undo step.

  void undo();
  void redo();
  void jump_to_step(std::size_t index);  ///< of history().steps()
  void delete_selected();
  /// Changes what the solver does not see of the selected handles; nothing when all stay alike.
  void change_selected(const std::string& label, const std::function<void(Handle&)>& change);
  void reset_pose();
  void set_energy(const Density& energy);
  void set_method(std::string_view name);
  /// Clamped to the row's range; changes of one row within a second make one step.
  void set_parameter(const ParameterRow& row, double value);
  void reset_parameter(const ParameterRow& row);

  // Selection and view.

  void select(std::set<int> ids);
  void select_all();
  void invert_selection();
  void set_hovered(std::optional<int> id);
  void fit_all();
  void fit_selection();
  void zoom(double factor);  ///< about the middle of the canvas
  /// 100 design pixels a unit of length; one a pixel of the image where a mesh was made of one.
  void actual_size();
  void set_camera(const Camera& camera);
  /// Edges and outline of the mesh, or the picture alone.
  void show_mesh(bool shown);
  bool is_mesh_shown() const { return view_.layers.wireframe || view_.layers.boundary; }
  void hide_overlays(bool hidden);
  bool are_overlays_hidden() const { return overlays_hidden_; }

  // The solver and its timeline.

  SolvingState solving_state() const { return solving_.state(); }
  bool is_solving() const { return solving_.is_running(); }
  void toggle_pause();
  void stop_solving();
  /// Iterations a second, 1 … 60; nothing: as fast as it goes.
  void set_pace(std::optional<double> pace);
  std::optional<double> pace() const { return pace_; }
  /// Every iteration since the last edit, in order.
  const std::vector<Iteration>& iterations() const { return solving_.iterations(); }
  /// True when the solver rests and there is an iteration to go to.
  bool can_scrub() const;
  /// The iteration that is shown, when it is not the newest state.
  std::optional<std::size_t> scrubbed() const { return scrubbed_; }
  void scrub(std::size_t index);
  void leave_timeline();
  void use_iteration();  ///< makes what is shown the newest state, an undo step
  void step_forward();   ///< the next iteration of the timeline; at its end one of the solver
  void step_back();      ///< the iteration before; pauses first when solving
  void first_iteration();
  void last_iteration();
  /// Stages of Esc: cancel the gesture, stop solving, leave the timeline, deselect.
  void escape();

  // Side by side.

  const RemeshDiff& remesh_diff() const { return remesh_diff_; }
  void toggle_remesh_diff();
  void toggle_link();
  /// Moves the pane of the rest mesh, and the canvas with it when they are linked.
  void set_rest_camera(const Camera& camera);
  Race& race() { return race_; }
  const Race& race() const { return race_; }
  /// Opens a race with the document's handles, or closes it; the document stays as it is.
  void toggle_race();
  /// Closes the race; what a lane shows, and how it was made, becomes the document: an undo step.
  void use_race_lane(std::size_t index);

  // Why a handle does not get there.

  const StuckHandles& stuck() const { return stuck_; }
  /// The stuck handle that is talked about: the selected one, or the farthest; null without any.
  const StuckHandle* stuck_handle() const;
  void toggle_stuck();
  void flip_blocking();   ///< the edges that block it; an undo step
  void split_blocking();  ///< as the paper's rule does; an undo step

  // For tools.

  bool is_space_held() const { return space_.has_value(); }
  /// For picking: which sheet of the mesh on screen lies in front.
  PaintOrder& paint_order() { return paint_order_; }
  /// The document is about to change: what is on screen becomes the newest state.
  void begin_edit();
  /// The document as the edit makes it so far; the solver follows.
  void apply(Document document, Change change);
  /// Ends what begin_edit() began with one undo step.
  void commit(std::string label);
  /// Ends it with everything as it was.
  void abandon_edit();
  /// The next iteration will be the first of the timeline.
  void clear_timeline() { solving_.clear_timeline(); }

 private:
  struct Edit {
    Document before;
    bool was_solving = false;
  };
  struct SpaceKey {
    double since = 0;
    bool has_panned = false;
  };
  struct LastChange {
    std::string label;
    double time = 0;
  };

  void on(const PointerPressed& event);
  void on(const PointerMoved& event);
  void on(const PointerReleased& event);
  void on(const PointerLeft& event);
  void on(const WheelTurned& event);
  void on(const KeyPressed& event);
  void on(const KeyReleased& event);
  void on(const FilesDropped& event);
  void on(const FocusLost& event);
  void take_over(std::unique_ptr<Tool> next);
  void cancel_gesture();

  void edit(std::string label, Document document, Change change);
  void change_parameters(const std::string& label, Document document);
  void restore(const Document& document);
  void install(const Document& document, std::string label);
  void load(const PendingAction& action);
  void ask_or_perform(PendingAction action);
  void open_scene(const std::filesystem::path& path);
  void update_import();
  void follow_texture();
  void perform_pending();
  void mark_saved();

  void take_newest();
  void refresh_shown();
  void refresh_proof();
  void prune_selection();
  Box box_of(const std::vector<HandleView>& handles) const;

  EditorOptions options_;
  Document document_;
  History history_;
  Solving solving_;
  Canvas canvas_;
  bool needs_fit_ = true;
  ViewOptions view_;
  bool overlays_hidden_ = false;
  std::unique_ptr<Tool> tool_;
  std::optional<Edit> edit_;
  std::optional<LastChange> last_change_;  ///< of a parameter, to make one step of a slider's moves
  bool targets_moved_ = false;             ///< since the solver was told

  std::shared_ptr<const Snapshot> shown_;
  std::shared_ptr<const Snapshot> taken_;     ///< the solver's snapshot that the document has
  std::shared_ptr<const Snapshot> folded_;    ///< what the solver shows but no document may keep
  std::shared_ptr<const Snapshot> proved_;    ///< the pose that proof_ is about
  std::shared_ptr<const Snapshot> old_pose_;  ///< the chosen iteration's, null without one
  std::optional<std::size_t> scrubbed_;
  Proof proof_;
  PaintOrder paint_order_;
  std::optional<double> pace_;
  RemeshDiff remesh_diff_;
  ImageImport import_;
  bool takes_image_ = false;  ///< as soon as it is ready
  TextureImage texture_image_;
  Race race_;
  StuckHandles stuck_;

  std::set<int> selection_;
  std::optional<int> hovered_;
  Vec2 pointer_ = Vec2::Zero();
  std::optional<SpaceKey> space_;
  const Command* held_command_ = nullptr;  ///< whose key is down, if it lasts as long as that
  Key held_key_ = Key::none;

  std::vector<Toast> toasts_;
  int next_toast_ = 1;
  std::vector<Request> requests_;
  std::optional<PendingAction> pending_;
  bool is_asking_ = false;
  std::filesystem::path path_;
  RecentFiles recent_;
  std::uint64_t saved_step_ = 0;
  std::shared_ptr<const Snapshot> saved_pose_;  ///< null: any, the file holds none
  double now_ = 0;
  bool needs_redraw_ = true;
};

}  // namespace foldless
