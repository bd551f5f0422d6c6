// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/cli/calls.h"
#include "app/cli/option_texts.h"
#include "app/cli/subcommands.h"
#include "app/cli/version.h"
#include "core/error.h"

namespace foldless {
namespace {

/// With --ui. Throws Error where another option asks for what the editor itself decides.
EditorPictureCall editor_picture_call(const CLI::App& render, const RenderCall& call,
                                      const Texts& texts) {
  for (const char* const flag : {"--view", "--layers", "--texture", "--samples", "--background",
                                 "--camera", "--line-width", "--transparent", "--miniature"})
    if (render.count(flag) > 0)
      throw Error("--ui shows the editor as it opens the file: leave out " + std::string(flag));
  if (call.picture.extension() != ".png")
    throw Error(call.picture.string() + ": --ui writes a PNG; end the name with .png");
  return editor_picture(texts, call);
}

/// Subcommands with what they are given: that of a name, or all where none has it. To describe the
/// options of all of them takes as long as to solve a small scene.
struct Subcommands {
  Subcommands(CLI::App& app, std::string_view name) {
    const std::pair<const char*, std::function<void()>> all[] = {
        {"solve", [&] { add_solve(app, solve, texts); }},
        {"animate", [&] { add_animate(app, animate, texts, animate_flags); }},
        {"render", [&] { add_render(app, render, texts, render_flags); }},
        {"mesh", [&] { add_mesh(app, mesh); }},
        {"check", [&] { add_check(app, check); }},
        {"compare", [&] { add_compare(app, compare); }},
        {"replay", [&] { add_replay(app, replay, texts); }},
        {"bench", [&] { add_bench(app, bench, texts); }}};
    const bool is_one = std::ranges::any_of(all, [&](const auto& it) { return it.first == name; });
    for (const auto& [its_name, add] : all)
      if (!is_one || its_name == name) add();
  }

  ReplayCall replay;
  SolveCall solve;
  AnimateCall animate;
  RenderCall render;
  MeshCall mesh;
  CheckCall check;
  CompareCall compare;
  BenchCall bench;
  Texts texts;
  RenderFlags render_flags, animate_flags;
};

/// Of the subcommand that the command line begins with; empty where there is none.
std::string name_called(const CLI::App& app) {
  const std::vector<CLI::App*> called = app.get_subcommands();
  return called.empty() ? "" : called.front()->get_name();
}

/// The call of the subcommand that was named; nothing where none was.
std::optional<Call> named_call(const CLI::App& app, Subcommands& given) {
  const Texts& texts = given.texts;
  const std::string called = name_called(app);
  if (called == "solve") {
    read_solve(texts, given.solve);
    return given.solve;
  }
  if (called == "animate") {
    read_animate(texts, given.animate_flags.is_transparent, given.animate);
    return given.animate;
  }
  if (called == "render") {
    if (given.render_flags.is_of_editor)
      return editor_picture_call(*app.get_subcommand("render"), given.render, texts);
    read_render(texts, given.render_flags.is_transparent, given.render);
    return given.render;
  }
  if (called == "mesh") return given.mesh;
  if (called == "check") {
    read_check(given.check);
    return given.check;
  }
  if (called == "compare") return given.compare;
  if (called == "replay") {
    if (!texts.size.empty()) given.replay.size = read_size(texts.size);
    return given.replay;
  }
  if (called == "bench") {
    read_bench(texts, given.bench);
    return given.bench;
  }
  return std::nullopt;
}

}  // namespace

Call parse_arguments(int argc, const char* const* argv) {
  const std::string program = argc > 0 ? argv[0] : "foldless";
  CLI::App app("Deforms planar meshes by dragged handles, and never folds them.", "foldless");
  bool wants_version = false, is_verbose = false;
  app.add_flag("--version", wants_version, "print the version and end");
  app.add_flag("--verbose", is_verbose, "with --version: what the program was built with, too");
  EditorCall editor;
  app.add_option(
      "FILE", editor.file,
      "scene, mesh or image to open in the editor; when absent recent files, or a sample");
  app.add_option(
         "--record", editor.record,
         "write what is done in the editor to a file, for replay; Shift+F12 takes a picture")
      ->type_name("SESSION");
  Subcommands subcommands(app, argc > 1 ? argv[1] : "");
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    const std::string called = name_called(app);
    CLI::App& of = called.empty() ? app : *app.get_subcommand(called);
    of.footer("Example:\n  " + example_of(called, program));
    return TextCall{app.help()};
  } catch (const CLI::ParseError& error) {
    throw Error(std::string(error.what()) + "; see " + program + " --help");
  }
  if (wants_version) return TextCall{is_verbose ? verbose_version_text() : version_text()};
  if (is_verbose) throw Error("--verbose goes with --version; see " + program + " --help");
  if (const auto call = named_call(app, subcommands)) return *call;
  return editor;
}

}  // namespace foldless
