// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/bench/bench_pool.h"
#include "app/bench/sweep.h"
#include "render/figure_options.h"

namespace foldless {

/// `foldless [FILE]`
struct EditorCall {
  std::optional<std::filesystem::path> file;
  std::filesystem::path record;  ///< session to write; empty: none
};

/// `foldless replay SESSION --shots DIR`
struct ReplayCall {
  std::filesystem::path session;
  std::filesystem::path shots;
  std::optional<std::array<int, 2>> size;  ///< width and height of the window [pixels]
};

/// A parameter given on the command line: its key under `solver` of a scene file, and the value.
struct ParameterOption {
  std::string key;
  double value;
};

/// `foldless solve SCENE -o DIR`
struct SolveCall {
  std::filesystem::path scene;              ///< or a folder or list of scenes
  std::filesystem::path folder;             ///< or that of a folder for each scene
  std::optional<Shard> shard;               ///< the part of the scenes; absent: all
  std::string method;                       ///< empty: that of the scene
  std::string energy;                       ///< empty: that of the scene
  std::vector<ParameterOption> parameters;  ///< instead of those of the scene
  std::optional<int> frame_step;            ///< a frame every so many meshes; absent: no frames
  std::optional<double> time_limit;         ///< processor seconds of solving; absent: none
  bool render = false;                      ///< a picture of the result and of every frame
  std::optional<int> threads;               ///< absent: as many as there are cores
  bool json = false;                        ///< the report on stdout, and nothing else
  bool quiet = false;                       ///< nothing on stdout
};

/// `foldless animate SCENE -o OUT`
struct AnimateCall {
  std::filesystem::path scene;
  std::filesystem::path output;             ///< its ending is one of animation_formats()
  std::optional<double> fps;                ///< absent: that of the animation
  std::optional<std::array<int, 2>> range;  ///< first and last frame
  std::optional<std::array<int, 2>> size;   ///< width and height [pixels]
  std::optional<Layers> layers;             ///< absent: what a drawing is shown with
  FigureOptions figure;                     ///< theme and background
  double tolerance = 0.5;                   ///< of a bake [pixels]
  bool power_of_two = false;                ///< sides of a sprite sheet
  bool quiet = false;                       ///< nothing on stdout
};

/// `foldless render FILE -o OUT`
struct RenderCall {
  std::string file;               ///< a scene, a mesh, a solved folder, or `rest,deformed`
  std::filesystem::path picture;  ///< .png, .svg or .pdf
  std::optional<std::filesystem::path> texture;  ///< instead of that of the scene
  FigureOptions figure;
};

/// `foldless render FILE -o OUT.png --ui`
struct EditorPictureCall {
  std::filesystem::path file;  ///< a scene, mesh or image
  std::filesystem::path picture;
  std::optional<std::array<int, 2>> size;  ///< width and height of the window [pixels]
  std::optional<Theme> theme;
};

/// `foldless mesh IMAGE -o OUT`; what is absent follows from the image
struct MeshCall {
  std::filesystem::path image;
  std::filesystem::path output;  ///< `.json` for a scene, or a mesh
  bool by_layer = false;         ///< a part for every layer
  std::optional<double> threshold, margin, simplify, edge_length, min_angle;
};

/// `foldless check REST DEFORMED [SCENE]`, or `foldless check ANIMATION`
struct CheckCall {
  std::filesystem::path rest;
  std::filesystem::path deformed;  ///< empty: `rest` is a baked animation
  std::optional<std::filesystem::path> scene;
};

/// `foldless compare A B`
struct CompareCall {
  std::filesystem::path first, second;        ///< images
  int tolerance = 0;                          ///< grey levels by which a channel may differ
  std::optional<std::filesystem::path> diff;  ///< picture of what differs
};

/// `foldless bench [SCENE...]`
struct BenchCall {
  std::string suite;  ///< `random`, `hard`, `paper`, `scale` or `drag`; empty: `scenes`
  /// Scene files, folders and lists of them; with `merge` files that --append wrote.
  std::vector<std::filesystem::path> scenes;
  std::vector<std::string> methods;  ///< empty: all
  std::uint64_t seed = 1;            ///< of the random and the hard suite
  int count = 60;                    ///< scenes of the random suite
  std::vector<int> only;             ///< indices of scenes, from 0; empty: all
  BenchOptions options;
  std::optional<std::filesystem::path> folder;  ///< for tables
  std::optional<std::filesystem::path> keep;    ///< for the scenes as files
  std::optional<Shard> shard;                   ///< the part of the runs that is made; absent: all
  std::optional<std::filesystem::path> append;  ///< for a record of every run
  bool merge = false;                           ///< run nothing: tables of records
};

/// Text to print and nothing else to do: help or version.
struct TextCall {
  std::string text;
};

using Call = std::variant<EditorCall, ReplayCall, EditorPictureCall, SolveCall, AnimateCall,
                          RenderCall, MeshCall, CheckCall, CompareCall, BenchCall, TextCall>;

/// What the arguments ask for. Throws Error on arguments that make no call.
Call parse_arguments(int argc, const char* const* argv);

/// The calls; they print, return the exit status, and throw Error on bad input.
int solve(const SolveCall& call);
int animate(const AnimateCall& call);
int render(const RenderCall& call);
int mesh(const MeshCall& call);
int check(const CheckCall& call);
/// Of a baked animation.
int check_animation(const std::filesystem::path& file);
int compare(const CompareCall& call);
int bench(const BenchCall& call);

}  // namespace foldless
