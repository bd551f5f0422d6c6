// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/requests.h"

#include <array>
#include <functional>
#include <utility>

#include "app/editor/race_setup.h"
#include "app/editor/race_table.h"
#include "app/gui/export_place.h"
#include "app/gui/plot_export.h"
#include "core/data_path.h"
#include "core/error.h"
#include "core/files/atomic_file.h"
#include "render/image.h"

namespace foldless {
namespace {

/// The samples that come with the program.
std::vector<Place> data_places() {
  std::vector<Place> places;
  for (const auto& [label, folder] :
       {std::pair{"Sample scenes", "assets/scenes"}, std::pair{"Sample meshes", "assets/meshes"},
        std::pair{"Sample images", "assets/images"}}) {
    try {
      places.push_back({label, data_path(folder)});
    } catch (const Error&) {
      // A program without its samples still opens files.
    }
  }
  return places;
}

FileRequest open_request(const std::string& title, std::vector<std::string> extensions,
                         const Editor& editor, const UiState& state) {
  FileRequest request;
  request.title = title;
  request.extensions = std::move(extensions);
  request.start = starting_folder(editor, state);
  request.places = data_places();
  return request;
}

std::vector<std::string> image_endings() {
  return {image_extensions().begin(), image_extensions().end()};
}

void open_chosen(FileRequest request, Editor& editor, UiState& state) {
  request.chosen = [&editor, &state](const std::filesystem::path& path) {
    state.last_folder = path.parent_path();
    if (is_sample(path))
      editor.files().open_sample(path);
    else
      editor.files().open(path);
  };
  state.browser.ask(std::move(request));
}

void ask_what_to_open(Editor& editor, UiState& state) {
  std::vector<std::string> extensions = image_endings();
  extensions.insert(extensions.begin(), {".json", ".obj", ".off", ".ply"});
  auto request = open_request("Open", std::move(extensions), editor, state);
  open_chosen(std::move(request), editor, state);
}

void ask_for_image(Editor& editor, UiState& state) {
  auto request = open_request("New from an image", image_endings(), editor, state);
  open_chosen(std::move(request), editor, state);
}

void ask_for_texture(Editor& editor, UiState& state) {
  auto request = open_request("Open an image as texture", image_endings(), editor, state);
  request.chosen = [&editor, &state](const std::filesystem::path& path) {
    state.last_folder = path.parent_path();
    editor.files().set_texture(path);
  };
  state.browser.ask(std::move(request));
}

void ask_where_to_save(Editor& editor, UiState& state) {
  FileRequest request;
  request.purpose = FileRequest::Purpose::save;
  request.title = "Save the scene";
  request.extensions = {".json"};
  request.start = starting_folder(editor, state) / (suggested_name(editor) + ".json");
  request.chosen = [&editor, &state](const std::filesystem::path& path) {
    state.last_folder = path.parent_path();
    const std::string problem = editor.files().try_save_as(path);
    if (!problem.empty()) state.browser.ask_again(problem);
  };
  request.dismissed = [&editor] { editor.files().answer(Answer::cancel); };
  state.browser.ask(std::move(request));
}

void order_snapshot(Editor& editor, UiState& state, const std::filesystem::path& pictures_folder) {
  const auto folder = editor.files().path().empty() && !pictures_folder.empty()
                          ? pictures_folder
                          : starting_folder(editor, state);
  ExportJob job;
  job.path = numbered_picture(folder, suggested_name(editor));
  job.picture.layers = exported_layers(editor);
  state.exporting.order(std::move(job));
}

/// What a text file will hold, made when the user has chosen where.
struct TextExport {
  std::string title;
  std::string ending;                   ///< of the suggested name
  std::vector<std::string> extensions;  ///< that the text can have
  /// For a file of that name. Throws Error where that cannot be.
  std::function<std::string(const std::filesystem::path&)> text;
};

void ask_where_to_export(const TextExport& job, Editor& editor, UiState& state) {
  FileRequest request;
  request.purpose = FileRequest::Purpose::save;
  request.title = job.title;
  request.extensions = job.extensions;
  request.start = suggested_export(editor, state, job.ending);
  request.chosen = [&editor, &state, text = job.text](const std::filesystem::path& path) {
    remember_export(editor, state, path);
    try {
      expect_no_export_of_source(editor, path);
      write_file_atomically(path, text(path));
      editor.messages().toast(ToastKind::notice, "Wrote " + path.string());
    } catch (const Error& error) {
      state.browser.ask_again(error.what());
    }
  };
  state.browser.ask(std::move(request));
}

void export_csv(Editor& editor, UiState& state) {
  ask_where_to_export({"Export the iterations",
                       "-iterations.csv",
                       {".csv"},
                       [&editor](const auto&) { return convergence_csv(editor); }},
                      editor, state);
}

/// A race shows energy, gradient, residual and distortion.
void export_svg(Editor& editor, UiState& state) {
  const auto shown =
      editor.race().is_open() ? std::array<bool, 8>{true, true, true, true} : state.shown_series;
  ask_where_to_export({"Export the convergence plots",
                       "-convergence.svg",
                       {".svg"},
                       [&editor, shown](const auto&) { return convergence_svg(editor, shown); }},
                      editor, state);
}

/// The race may be closed while the user chooses: the table is that of now.
void export_table(Editor& editor, UiState& state) {
  const auto table = [csv = race_table_csv(editor.race()),
                      latex = race_table_latex(editor.race())](const std::filesystem::path& file) {
    return is_latex_table(file) ? latex : csv;
  };
  ask_where_to_export(
      {"Export the race's table: .csv or .tex", "-race.csv", {".csv", ".tex"}, table}, editor,
      state);
}

}  // namespace

/// The race may have got other lanes while the user chose.
void ask_for_lane_scene(std::size_t lane, Editor& editor, UiState& state) {
  auto request = open_request("A lane as in a scene", {".json"}, editor, state);
  request.chosen = [lane, &editor, &state](const std::filesystem::path& path) {
    state.last_folder = path.parent_path();
    if (!editor.race().is_open() || lane >= editor.race().setup().lane_count()) return;
    try {
      RaceSetup setup = editor.race().setup();
      setup.scenes[lane] = load_race_scene(path);
      editor.race().set_setup(std::move(setup));
    } catch (const Error& error) {
      editor.messages().toast(ToastKind::error, error.what());
    }
  };
  state.browser.ask(std::move(request));
}

bool handle_requests(Editor& editor, UiState& state, const std::filesystem::path& pictures_folder) {
  const auto requests = editor.messages().take_requests();
  for (const Request request : requests) {
    switch (request) {
      case Request::open_dialog: ask_what_to_open(editor, state); break;
      case Request::image_dialog: ask_for_image(editor, state); break;
      case Request::save_dialog: ask_where_to_save(editor, state); break;
      case Request::texture_dialog: ask_for_texture(editor, state); break;
      case Request::write_snapshot: order_snapshot(editor, state, pictures_folder); break;
      case Request::export_dialog: state.exporting.open(editor); break;
      case Request::export_again: state.exporting.repeat(editor); break;
      case Request::export_csv: export_csv(editor, state); break;
      case Request::export_svg: export_svg(editor, state); break;
      case Request::export_table: export_table(editor, state); break;
      case Request::command_search: state.search.open(); break;
      case Request::cheat_sheet: state.opens_cheat_sheet = true; break;
      case Request::quit: state.wants_to_quit = true; break;
    }
  }
  return !requests.empty();
}

}  // namespace foldless
