// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <cstddef>
#include <string>
#include <string_view>

#include "app/cli/calls.h"
#include "app/cli/option_texts.h"
#include "app/cli/version.h"
#include "core/data_path.h"
#include "core/energy/densities.h"
#include "core/error.h"
#include "core/method/methods.h"
#include "core/scene/parameter_keys.h"

namespace foldless {
namespace {

/// A sample that the examples of the help name, by its path where it is installed.
std::string sample(std::string_view file = "assets/scenes/figure5_coarse_disk.json") {
  try {
    return data_path(file).lexically_normal().string();
  } catch (const Error&) {
    return std::string(file);
  }
}

CLI::App* add_solve(CLI::App& app, SolveCall& call, Texts& texts) {
  CLI::App* solve = app.add_subcommand("solve", "run the solver on a scene, without a window");
  solve->add_option("SCENE", call.scene, "scene file (JSON)")->required();
  solve->add_option("-o,--output", call.folder, "folder for what is written; made if need be")
      ->required()
      ->type_name("DIR");
  solve->add_option("--method", call.method, "one of: " + names_of(methods()))->type_name("NAME");
  solve->add_option("--energy", call.energy, "one of: " + names_of(densities()))->type_name("NAME");
  for (std::size_t i = 0; i < kNumberOptions.size(); ++i)
    solve->add_option(kNumberOptions[i].flag, texts.numbers[i], kNumberOptions[i].help)
        ->type_name("NUMBER");
  solve
      ->add_option(
          "--start", texts.start,
          "first frames of bounded-conformal: " + words_of(find_parameter_key("start")->words))
      ->type_name("NAME");
  solve->add_option("--frames", texts.frames, "write all intermediate meshes, or every N-th")
      ->type_name("all|N");
  solve
      ->add_option("--time-limit", texts.time_limit,
                   "processor seconds of solving; what was reached by then is written")
      ->type_name("SECONDS");
  solve->add_flag("--render", call.render, "draw the result and every frame as PNG");
  solve->add_option("--threads", call.threads, "threads for drawing; the solver itself uses one")
      ->type_name("N");
  solve->add_flag("--json", call.json, "print the report on stdout, and nothing else");
  solve->add_flag("--quiet", call.quiet, "print nothing but errors");
  return solve;
}

/// The flags of `render` that are no values.
struct RenderFlags {
  bool is_transparent = false;
  bool is_of_editor = false;
};

CLI::App* add_render(CLI::App& app, RenderCall& call, Texts& texts, RenderFlags& flags) {
  CLI::App* render = app.add_subcommand("render", "draw a scene or a solved folder off screen");
  render->add_option("FILE", call.file, "scene, mesh, folder written by solve, or rest,deformed")
      ->required();
  render->add_option("-o,--output", call.picture, "picture to write, .png, .svg or .pdf")
      ->required()
      ->type_name("OUT");
  render->add_option("--size", texts.size, "size in pixels, 1200x900 when absent")
      ->type_name("WxH");
  render->add_option("--view", texts.view, "deformed (when absent), rest or both")
      ->type_name("VIEW");
  render->add_option("--layers", texts.layers, "comma-separated: " + names_of(kLayerRows))
      ->type_name("LIST");
  render->add_option("--texture", call.texture, "image instead of the checkerboard")
      ->type_name("IMAGE");
  render->add_option("--samples", call.figure.samples, "samples a pixel, 4 when absent")
      ->type_name("N");
  render->add_option("--theme", texts.theme, "light (when absent), dark or contrast")
      ->type_name("NAME");
  render->add_option("--background", texts.background, "colour behind the drawing")
      ->type_name("#RRGGBB");
  render
      ->add_option("--camera", texts.camera,
                   "the point of the plane in the middle, and pixels a unit of length")
      ->type_name("X,Y,ZOOM");
  render->add_option("--line-width", texts.line_width, "factor on the width of edges")
      ->type_name("FACTOR");
  render->add_flag("--transparent", flags.is_transparent, "transparent background");
  render->add_flag("--ui", flags.is_of_editor,
                   "the whole editor with the file open, as PNG; takes --size and --theme alone");
  render->add_flag("--miniature", call.figure.miniature,
                   "the deformed mesh once more, small, with its checkerboard alone");
  return render;
}

CLI::App* add_mesh(CLI::App& app, MeshCall& call) {
  CLI::App* mesh = app.add_subcommand("mesh", "make a triangle mesh of what an image shows");
  mesh->add_option("IMAGE", call.image,
                   "PNG, JPEG, WebP, OpenRaster, Krita or Photoshop; transparent is outside")
      ->required();
  mesh->add_option("-o,--output", call.output, "scene with the image as texture, or mesh")
      ->required()
      ->type_name("OUT.json|OUT.obj");
  mesh->add_flag("--layers", call.by_layer, "a part of the mesh for every layer of the file");
  mesh->add_option("--edge-length", call.edge_length, "no edge is longer")->type_name("PX");
  mesh->add_option("--margin", call.margin, "pixels that the outline keeps away from the figure")
      ->type_name("PX");
  mesh->add_option("--min-angle", call.min_angle, "of the triangles, 0 to 33, 20.7 when absent")
      ->type_name("DEG");
  mesh->add_option("--simplify", call.simplify, "pixels by which the outline may be off")
      ->type_name("PX");
  mesh->add_option("--threshold", call.threshold,
                   "alpha, 0 to 1, from which on a pixel belongs to the figure; 0.1 when absent")
      ->type_name("ALPHA");
  return mesh;
}

CLI::App* add_check(CLI::App& app, CheckCall& call) {
  CLI::App* check = app.add_subcommand("check", "prove that a map is locally injective");
  check->add_option("REST", call.rest, "rest mesh (OBJ, OFF, PLY)")->required();
  check->add_option("DEFORMED", call.deformed, "the same triangles, deformed")->required();
  check->add_option("SCENE", call.scene, "scene whose handles are checked too");
  return check;
}

CLI::App* add_compare(CLI::App& app, CompareCall& call) {
  CLI::App* compare = app.add_subcommand("compare", "tell whether two pictures are alike");
  compare->add_option("A", call.first, "PNG, JPEG or WebP")->required();
  compare->add_option("B", call.second, "the other one")->required();
  compare
      ->add_option("--tolerance", call.tolerance,
                   "grey levels by which a channel may differ, 0 when absent")
      ->type_name("T");
  compare->add_option("--diff", call.diff, "picture of A, pale, with what differs in red")
      ->type_name("OUT.png");
  return compare;
}

CLI::App* add_replay(CLI::App& app, ReplayCall& call, Texts& texts) {
  CLI::App* replay =
      app.add_subcommand("replay", "play a recorded session in the editor, without a window");
  replay->add_option("SESSION", call.session, "JSON lines that --record wrote")->required();
  replay->add_option("--shots", call.shots, "folder for the pictures; made if need be")
      ->required()
      ->type_name("DIR");
  replay->add_option("--size", texts.size, "of the window, instead of the session's")
      ->type_name("WxH");
  return replay;
}

CLI::App* add_bench(CLI::App& app, BenchCall& call, Texts& texts) {
  CLI::App* bench = app.add_subcommand("bench", "run methods side by side over many scenes");
  bench->add_option("SCENE", call.scenes, "scene files, where no suite is named");
  bench
      ->add_option("--suite", call.suite,
                   "random: scenes drawn from a seed; hard: 216 that are hard to reach, likewise; "
                   "paper: Table 1 and Figure 13; scale: meshes of two thousand to a million "
                   "triangles; drag: how targets that move frame by frame are followed")
      ->type_name("NAME");
  bench
      ->add_option("--method", texts.methods,
                   "comma-separated, all when absent: " + names_of(methods()))
      ->type_name("LIST");
  bench->add_option("--seed", call.seed, "of the random and the hard suite, 1 when absent")
      ->type_name("S");
  bench->add_option("--count", call.count, "scenes of the random suite, 60 when absent")
      ->type_name("N");
  bench->add_option("--only", texts.only, "comma-separated indices of scenes, from 0")
      ->type_name("LIST");
  bench->add_option("--jobs", call.options.threads, "runs at a time, 1 when absent")
      ->type_name("N");
  bench->add_option("--repeat", call.options.repeat, "runs of which the median time counts")
      ->type_name("N");
  bench
      ->add_option("--time-limit", call.options.time_limit,
                   "processor seconds of a run, 60 when absent")
      ->type_name("SECONDS");
  bench
      ->add_option("-o,--output", call.folder,
                   "folder for results.csv, results.json and tables in Markdown and LaTeX")
      ->type_name("DIR");
  bench->add_option("--keep", call.keep, "folder for the scenes as files")->type_name("DIR");
  return bench;
}

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

/// Every help ends with an example that can be pasted.
void add_examples(CLI::App& app, const std::string& program) {
  const std::string solved = program + " solve " + sample() + " -o coarse_disk";
  app.footer("Example:\n  " + program + " " + sample());
  app.get_subcommand("solve")->footer("Example:\n  " + solved + " --frames all --render");
  app.get_subcommand("render")->footer("Example:\n  " + program + " render " + sample() +
                                       " -o coarse_disk.png --view both");
  app.get_subcommand("bench")->footer("Example:\n  " + program + " bench " + sample() +
                                      " --method paper-flip,paper-noflip");
  app.get_subcommand("mesh")->footer("Example:\n  " + program + " mesh " +
                                     sample("assets/images/editor.png") + " -o drawing.json && " +
                                     program + " drawing.json");
  app.get_subcommand("compare")->footer(
      "Example:\n  " + program + " render " + sample("assets/scenes/welcome.json") +
      " -o picture.png && " + program + " compare picture.png picture.png --tolerance 2");
  app.get_subcommand("replay")->footer(
      "Example:\n  " + program + " " + sample("assets/scenes/welcome.json") +
      " --record session.jsonl && " + program + " replay session.jsonl --shots shots");
  app.get_subcommand("check")->footer("Example:\n  " + solved + " && " + program +
                                      " check coarse_disk/rest.obj coarse_disk/deformed.obj");
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
  if (render->parsed()) {
    if (render_flags.is_of_editor) return editor_picture_call(*render, render_call, texts);
    read_render(texts, render_flags.is_transparent, render_call);
    return render_call;
  }
  if (mesh->parsed()) return mesh_call;
  if (check->parsed()) return check_call;
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
