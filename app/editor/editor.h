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
#include "app/editor/document.h"
#include "app/editor/history.h"
#include "app/editor/input.h"
#include "app/editor/messages.h"
#include "app/editor/parameter_rows.h"
#include "app/editor/picking.h"
#include "app/editor/recent_files.h"
#include "app/editor/solving.h"
#include "app/editor/tool.h"
#include "render/view_options.h"

namespace foldless {

/// What an editor needs from outside.
struct EditorOptions {
  std::filesystem::path state_folder;  ///< holds the recent files; empty: nothing is kept on disk
  std::function<void()> wake;          ///< called on the solver's thread when update() has news
  std::size_t history_bytes = std::size_t{512} << 20;
};

/// The program without its window: a document, its history, what is selected and seen, and the
/// solver behind it. Takes plain input events, says what to draw. One thread only. Never throws on
/// bad files or refused edits: it shows a toast.
class Editor {
 public:
  explicit Editor(EditorOptions options = {});
  ~Editor();

  // The loop: events in, then one update a frame.

  /// Size of the canvas in framebuffer pixels and framebuffer pixels in one design pixel.
  void resize(int width, int height, double ui_scale);
  /// `now` is a clock that never goes back. [s]
  void receive(const InputEvent& event, double now);
  /// Sends the newest targets to the solver and takes its newest state. Returns whether something
  /// on screen may have changed since the last call.
  bool update(double now);
  /// When update() must be called again though nothing happens (a toast goes away), if ever. [s]
  std::optional<double> next_wake() const;

  // What to draw.

  /// The mesh on screen, or null when nothing is open: the newest state, or the chosen iteration.
  /// Its handles have the newest targets.
  std::shared_ptr<const Snapshot> shown() const { return shown_; }
  const Canvas& canvas() const { return canvas_; }
  /// The options to draw with: overlays are off while H is held, handles follow ui_scale.
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
  /// "scene.json" or the mesh's name, with a leading "● " when there is something to save.
  std::string title() const;
  const std::vector<Toast>& toasts() const { return toasts_; }
  void dismiss_toast(int id);

  const Document& document() const { return document_; }
  const History& history() const { return history_; }
  /// True while a gesture changes the document.
  bool is_editing() const { return tool_->is_editing(); }

  // Commands; see commands.h.

  /// Runs a command of the table if it is enabled; returns whether it was.
  bool run_command(std::string_view name);
  std::vector<Request> take_requests();
  void request(Request request);

  // Files.

  /// Opens a scene, a mesh, or an image as the texture of the present mesh, by its extension;
  /// asks first when there are unsaved changes (not for a texture).
  void open(const std::filesystem::path& path);
  /// Opens a mesh that was made, not read. Precondition: valid. Unsaved changes are dropped.
  void open_shape(Shape shape, std::string name);
  void new_document();
  void save();
  bool save_as(const std::filesystem::path& path);
  void set_texture(const std::filesystem::path& path);
  void clear_texture();
  void close();                                                ///< the window's close button
  const std::filesystem::path& path() const { return path_; }  ///< of the scene; empty: never saved
  bool is_dirty() const;
  /// The action that waits for an answer about unsaved changes: "Save changes to …?"
  const std::optional<PendingAction>& question() const { return question_; }
  void answer(Answer answer);
  const std::vector<std::filesystem::path>& recent() const { return recent_.paths(); }

  // Edits; each is one undo step.

  void undo();
  void redo();
  void jump_to_step(std::size_t index);  ///< of history().steps()
  void delete_selected();
  void reset_pose();
  void set_energy(const Density& energy);
  void set_method(std::string_view name);
  /// Clamped to the row's range; moves of one slider within a second make one step.
  void set_parameter(const ParameterRow& row, double value);
  void reset_parameter(const ParameterRow& row);

  // Selection and view.

  void select(std::set<int> ids);
  void select_all();
  void invert_selection();
  void fit_all();
  void fit_selection();
  void zoom(double factor);  ///< about the middle of the canvas
  void actual_size();        ///< 100 pixels × UI scale a unit of length
  void set_camera(const Camera& camera);
  void hide_overlays(bool hidden);

  // The solver and its timeline.

  bool is_solving() const { return solving_.is_running(); }
  void toggle_pause();
  void stop_solving();
  /// Iterations a second, 1 … 60; nothing: as fast as it goes.
  void set_pace(std::optional<double> pace);
  std::optional<double> pace() const { return pace_; }
  /// Every iteration since the last edit, in order.
  const std::vector<Iteration>& iterations() const { return solving_.iterations(); }
  bool can_scrub() const;
  /// The iteration that is shown instead of the newest state.
  std::optional<std::size_t> scrubbed() const { return scrubbed_; }
  void scrub(std::size_t index);
  void leave_timeline();
  void use_iteration();  ///< an undo step
  void step_forward();   ///< `.`: the next iteration of the timeline, or one of the solver
  void step_back();      ///< `,`
  void first_iteration();
  void last_iteration();
  /// Stages of Esc: cancel the gesture, stop solving, leave the timeline, deselect.
  void escape();

  // For tools.

  /// A gesture or command is about to change the document: what is on screen becomes current.
  void begin_edit();
  /// The document as the gesture makes it; the solver follows. `is_mesh_new`: handles or mesh
  /// changed, not only targets.
  void apply(Document document, bool is_mesh_new);
  /// Ends what begin_edit() began with one undo step.
  void commit(std::string label);
  /// Ends it with everything as it was.
  void abandon_edit();
  void toast(ToastKind kind, std::string text);
  void set_hovered(std::optional<int> id);
  void redraw() { needs_redraw_ = true; }

 private:
  struct Edit;

  EditorOptions options_;
  Document document_;
  History history_;
  Solving solving_;
  Canvas canvas_;
  ViewOptions view_;
  std::unique_ptr<Tool> tool_;
  std::shared_ptr<const Snapshot> shown_;
  Proof proof_;
  std::set<int> selection_;
  std::optional<int> hovered_;
  std::optional<std::size_t> scrubbed_;
  std::optional<double> pace_;
  std::vector<Toast> toasts_;
  std::vector<Request> requests_;
  std::optional<PendingAction> question_;
  std::filesystem::path path_;
  RecentFiles recent_;
  bool needs_redraw_ = true;
};

}  // namespace foldless
