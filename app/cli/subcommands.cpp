// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/subcommands.h"

#include <cstddef>
#include <string_view>

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

}  // namespace

CLI::App* add_solve(CLI::App& app, SolveCall& call, Texts& texts) {
  CLI::App* solve = app.add_subcommand("solve", "run the solver on a scene, without a window");
  solve
      ->add_option("SCENE", call.scene,
                   "scene (JSON, or OBJ with handles.txt), folder or .txt list of them")
      ->required();
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
  solve->add_option("--shard", texts.shard, "of a folder or list every N-th scene from the I-th on")
      ->type_name("I/N");
  solve->add_flag("--render", call.render, "draw the result and every frame as PNG");
  solve->add_option("--threads", call.threads, "for solving and drawing, all cores when absent")
      ->type_name("N");
  solve->add_flag("--json", call.json, "print the report on stdout, and nothing else");
  solve->add_flag("--quiet", call.quiet, "print nothing but errors");
  return solve;
}

CLI::App* add_animate(CLI::App& app, AnimateCall& call, Texts& texts, RenderFlags& flags) {
  CLI::App* animate =
      app.add_subcommand("animate",
                         "solve the animation of a scene and write it as pictures, or "
                         "baked onto one mesh and proved between all frames");
  animate->add_option("SCENE", call.scene, "scene file with an animation")->required();
  animate
      ->add_option(
          "-o,--output", call.output,
          ".png or .apng (animated), .gif, .webp, .mp4, .webm, .json (sprite sheet), .glb, "
          ".spine.json, .tscn or .foldless (baked), or a new folder")
      ->required()
      ->type_name("OUT");
  animate->add_option("--fps", texts.fps, "frames a second, those of the scene when absent")
      ->type_name("N");
  animate->add_option("--range", texts.range, "first and last frame that is written, from 0")
      ->type_name("A-B");
  animate->add_option("--size", texts.size, "size in pixels; 1024 at the longer side when absent")
      ->type_name("WxH");
  animate->add_option("--layers", texts.layers, "comma-separated: " + names_of(kLayerRows))
      ->type_name("LIST");
  animate->add_option("--theme", texts.theme, "light (when absent), dark or contrast")
      ->type_name("NAME");
  animate->add_option("--background", texts.background, "colour behind the drawing")
      ->type_name("#RRGGBB");
  animate->add_flag("--transparent", flags.is_transparent, "transparent background");
  animate
      ->add_option("--bake-tolerance", call.tolerance,
                   "pixels by which a baked point may be off the solver's map, 0.5 when absent")
      ->type_name("PX");
  animate->add_flag("--power-of-two", call.power_of_two, "sides of a sprite sheet");
  animate->add_flag("--quiet", call.quiet, "print nothing but errors");
  return animate;
}

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
                   "PNG, JPEG, WebP, GIF, OpenRaster, Krita or Photoshop; transparent is outside")
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
  check->add_option("REST", call.rest, "rest mesh (OBJ, OFF, PLY), or a baked animation alone")
      ->required();
  check->add_option("DEFORMED", call.deformed, "the same triangles, deformed");
  check->add_option("SCENE", call.scene, "scene whose handles are checked too");
  return check;
}

CLI::App* add_compare(CLI::App& app, CompareCall& call) {
  CLI::App* compare = app.add_subcommand("compare", "tell whether two pictures are alike");
  compare->add_option("A", call.first, "PNG, JPEG, WebP or GIF")->required();
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
  bench->add_option("SCENE", call.scenes,
                    "scene files, folders or .txt lists of them, where no suite is named");
  bench
      ->add_option("--suite", call.suite,
                   "random: scenes drawn from a seed; hard: 216 that are hard to reach, likewise; "
                   "paper: Table 1 and Figure 13; scale: meshes of two thousand to two million "
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
  bench->add_option("--threads", call.options.team, "threads of each run, 1 when absent")
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
  bench->add_option("--shard", texts.shard, "make every N-th run only, from the I-th on, 1 to N")
      ->type_name("I/N");
  bench
      ->add_option("--append", call.append,
                   "add a line of JSON for every run at once, and skip the runs that are there")
      ->type_name("FILE");
  bench->add_flag("--merge", call.merge, "run nothing: tables of the files that --append wrote");
  return bench;
}

std::string example_of(const std::string& subcommand, const std::string& program) {
  const std::string called = program + " " + subcommand + " ";
  const std::string solved = program + " solve " + sample() + " -o coarse_disk";
  if (subcommand == "solve") return solved + " --frames all --render";
  if (subcommand == "animate")
    return called + sample("assets/scenes/walk.json") + " -o walk.foldless && " + program +
           " check walk.foldless";
  if (subcommand == "render") return called + sample() + " -o coarse_disk.png --view both";
  if (subcommand == "bench") return called + sample() + " --method paper-flip,paper-noflip";
  if (subcommand == "mesh")
    return called + sample("assets/images/editor.png") + " -o drawing.json && " + program +
           " drawing.json";
  if (subcommand == "compare")
    return program + " render " + sample("assets/scenes/welcome.json") + " -o picture.png && " +
           called + "picture.png picture.png --tolerance 2";
  if (subcommand == "replay")
    return program + " " + sample("assets/scenes/welcome.json") + " --record session.jsonl && " +
           called + "session.jsonl --shots shots";
  if (subcommand == "check")
    return solved + " && " + called + "coarse_disk/rest.obj coarse_disk/deformed.obj";
  return program + " " + sample();
}

}  // namespace foldless
