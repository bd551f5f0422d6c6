// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <string>

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

}  // namespace

Call parse_arguments(int argc, const char* const* argv) {
  const std::string program = argc > 0 ? argv[0] : "foldless";
  CLI::App app("Deforms planar meshes by dragged handles, and never folds them.", "foldless");
  bool wants_version = false, is_verbose = false;
  app.add_flag("--version", wants_version, "print the version and end");
  app.add_flag("--verbose", is_verbose, "with --version: what the program was built with, too");
  EditorCall editor;
  ReplayCall replay_call;
  SolveCall solve_call;
  AnimateCall animate_call;
  RenderCall render_call;
  MeshCall mesh_call;
  CheckCall check_call;
  CompareCall compare_call;
  BenchCall bench_call;
  Texts texts;
  RenderFlags render_flags;
  app.add_option("FILE", editor.file,
                 "scene, mesh or image to open in the editor; a sample when absent");
  app.add_option(
         "--record", editor.record,
         "write what is done in the editor to a file, for replay; Shift+F12 takes a picture")
      ->type_name("SESSION");
  const CLI::App* solve = add_solve(app, solve_call, texts);
  RenderFlags animate_flags;
  const CLI::App* animate = add_animate(app, animate_call, texts, animate_flags);
  const CLI::App* render = add_render(app, render_call, texts, render_flags);
  const CLI::App* mesh = add_mesh(app, mesh_call);
  const CLI::App* check = add_check(app, check_call);
  const CLI::App* compare = add_compare(app, compare_call);
  const CLI::App* replay = add_replay(app, replay_call, texts);
  const CLI::App* bench = add_bench(app, bench_call, texts);
  add_examples(app, program);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return TextCall{app.help()};
  } catch (const CLI::ParseError& error) {
    throw Error(std::string(error.what()) + "; see " + program + " --help");
  }
  if (wants_version) return TextCall{is_verbose ? verbose_version_text() : version_text()};
  if (is_verbose) throw Error("--verbose goes with --version; see " + program + " --help");
  if (solve->parsed()) {
    read_solve(texts, solve_call);
    return solve_call;
  }
  if (animate->parsed()) {
    read_animate(texts, animate_flags.is_transparent, animate_call);
    return animate_call;
  }
  if (render->parsed()) {
    if (render_flags.is_of_editor) return editor_picture_call(*render, render_call, texts);
    read_render(texts, render_flags.is_transparent, render_call);
    return render_call;
  }
  if (mesh->parsed()) return mesh_call;
  if (check->parsed()) {
    read_check(check_call);
    return check_call;
  }
  if (compare->parsed()) return compare_call;
  if (replay->parsed()) {
    if (!texts.size.empty()) replay_call.size = read_size(texts.size);
    return replay_call;
  }
  if (bench->parsed()) {
    read_bench(texts, bench_call);
    return bench_call;
  }
  return editor;
}

}  // namespace foldless
