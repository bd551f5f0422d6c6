// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/option_texts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <vector>

#include "app/cli/scene_files.h"
#include "app/export/animation_format.h"
#include "core/energy/densities.h"
#include "core/error.h"
#include "core/files/text_lines.h"
#include "core/method/methods.h"
#include "core/motion/animation.h"
#include "core/scene/parameter_keys.h"

namespace foldless {
namespace {

/// Of a list with commas.
std::vector<std::string> items_of(const std::string& list) {
  std::vector<std::string> items;
  std::istringstream text(list);
  for (std::string item; std::getline(text, item, ',');) items.push_back(item);
  return items;
}

template <typename Rows>
void expect_name(const char* flag, const std::string& name, const Rows& rows) {
  if (name.empty() || std::ranges::find(rows, name, [](const auto& row) { return row.name; }) !=
                          std::ranges::end(rows))
    return;
  throw Error(std::string(flag) + " " + in_quotes(name) +
              " is unknown; choose one of: " + names_of(rows));
}

int positive_integer(std::string_view text, const std::string& what) {
  const auto number = parse_integer(text);
  if (!number || *number < 1) throw Error(what + ", not " + in_quotes(text));
  return *number;
}

void read_start(const std::string& word, SolveCall& call) {
  const ParameterKey& key = *find_parameter_key("start");
  const auto index = index_of_word(key, word);
  if (!index)
    throw Error("--start " + in_quotes(word) +
                " is unknown; choose one of: " + words_of(key.words));
  call.parameters.push_back({std::string(key.name), *index});
}

double read_seconds(const std::string& text) {
  const auto seconds = parse_number(text);
  if (!seconds || *seconds <= 0)
    throw Error("--time-limit takes a number of seconds above 0, not " + in_quotes(text));
  return *seconds;
}

FigureView read_view(const std::string& text) {
  if (text == "deformed") return FigureView::deformed;
  if (text == "rest") return FigureView::rest;
  if (text == "both") return FigureView::both;
  throw Error("--view takes deformed, rest or both, not " + in_quotes(text));
}

Layers read_layers(const std::string& text) {
  Layers layers;
  for (const LayerRow& row : kLayerRows) layers.*row.shown = false;
  for (const std::string& name : items_of(text)) {
    const auto row = std::ranges::find(kLayerRows, name, &LayerRow::name);
    if (row == kLayerRows.end())
      throw Error("--layers " + in_quotes(name) +
                  " is unknown; choose among: " + names_of(kLayerRows));
    layers.*(row->shown) = true;
  }
  return layers;
}

Theme read_theme(const std::string& text) {
  constexpr std::array kThemes{"dark", "light", "contrast"};  // in the order of Theme
  const auto name = std::ranges::find(kThemes, text);
  if (name == kThemes.end())
    throw Error("--theme takes dark, light or contrast, not " + in_quotes(text));
  return static_cast<Theme>(name - kThemes.begin());
}

Camera read_camera(const std::string& text) {
  const std::vector<std::string> items = items_of(text);
  std::array<double, 3> numbers{};
  bool is_good = items.size() == numbers.size();
  constexpr double kFarthest = 1e100;
  for (std::size_t i = 0; is_good && i < numbers.size(); ++i) {
    const auto number = parse_number(items[i]);
    is_good = number && std::abs(*number) < kFarthest;
    if (number) numbers[i] = *number;
  }
  if (!is_good || !(numbers[2] > 1 / kFarthest))
    throw Error("--camera takes X,Y,ZOOM, such as 0.5,0,800, with ZOOM pixels a unit of length " +
                std::string("above 0, not ") + in_quotes(text));
  return {{numbers[0], numbers[1]}, numbers[2]};
}

double read_line_width(const std::string& text) {
  const auto factor = parse_number(text);
  if (!factor || !(*factor > 0 && *factor <= 100))
    throw Error("--line-width takes a factor above 0, at most 100, not " + in_quotes(text));
  return *factor;
}

GroundColour read_colour(const std::string& text) {
  const bool is_colour = text.size() == 7 && text[0] == '#' &&
                         text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
  if (!is_colour) throw Error("--background takes a colour as #RRGGBB, not " + in_quotes(text));
  GroundColour colour{};
  for (std::size_t i = 0; i < colour.size(); ++i)
    colour[i] = static_cast<std::uint8_t>(std::stoi(text.substr(1 + 2 * i, 2), nullptr, 16));
  return colour;
}

std::array<int, 2> read_range(const std::string& text) {
  const std::size_t dash = text.find('-');
  const auto first = parse_integer(std::string_view(text).substr(0, dash));
  const auto last = dash == std::string::npos
                        ? std::nullopt
                        : parse_integer(std::string_view(text).substr(dash + 1));
  if (!first || !last || *first < 0 || *last < *first)
    throw Error("--range takes FIRST-LAST, such as 0-23, not " + in_quotes(text));
  return {*first, *last};
}

Shard read_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  const auto number = parse_integer(text.substr(0, slash));
  const auto count =
      slash == std::string::npos ? std::nullopt : parse_integer(text.substr(slash + 1));
  if (!number || !count || *number < 1 || *number > *count)
    throw Error("--shard takes one of 1/N to N/N, not " + in_quotes(text));
  return {*number, *count};
}

}  // namespace

std::string words_of(std::span<const std::string_view> words) {
  std::string list;
  for (const std::string_view word : words) list += (list.empty() ? "" : ", ") + std::string(word);
  return list;
}

void read_solve(const Texts& texts, SolveCall& call) {
  expect_name("--method", call.method, methods());
  expect_name("--energy", call.energy, densities());
  for (std::size_t i = 0; i < kNumberOptions.size(); ++i) {
    const std::string& text = texts.numbers[i];
    if (text.empty()) continue;
    const NumberOption& option = kNumberOptions[i];
    const auto value = parse_number(text);
    if (!value) throw Error(std::string(option.flag) + " " + in_quotes(text) + " is not a number");
    if (const auto no = objection(*find_parameter_key(option.key), *value))
      throw Error(std::string(option.flag) + " " + *no + ", but is " + text);
    call.parameters.push_back({std::string(option.key), *value});
  }
  if (!texts.start.empty()) read_start(texts.start, call);
  if (texts.frames == "all")
    call.frame_step = 1;
  else if (!texts.frames.empty())
    call.frame_step =
        positive_integer(texts.frames, "--frames takes `all` or a number of 1 or more");
  if (!texts.time_limit.empty()) call.time_limit = read_seconds(texts.time_limit);
  if (call.threads && *call.threads < 1) throw Error("--threads takes a number of 1 or more");
  if (texts.shard.empty()) return;
  call.shard = read_shard(texts.shard);
  if (!are_scenes(call.scene)) throw Error("--shard goes with a folder or a list of scenes");
}

std::array<int, 2> read_size(const std::string& text) {
  const std::size_t x = text.find('x');
  const std::string what = "--size takes WIDTHxHEIGHT in pixels, such as 1200x900";
  if (x == std::string::npos) throw Error(what + ", not " + in_quotes(text));
  return {positive_integer(std::string_view(text).substr(0, x), what),
          positive_integer(std::string_view(text).substr(x + 1), what)};
}

void read_render(const Texts& texts, bool is_transparent, RenderCall& call) {
  if (!texts.size.empty()) {
    const auto [width, height] = read_size(texts.size);
    call.figure.width = width;
    call.figure.height = height;
  }
  if (!texts.view.empty()) call.figure.view = read_view(texts.view);
  if (!texts.layers.empty()) call.figure.style.layers = read_layers(texts.layers);
  if (!texts.theme.empty()) call.figure.style.theme = read_theme(texts.theme);
  if (!texts.camera.empty()) call.figure.camera = read_camera(texts.camera);
  if (!texts.line_width.empty()) call.figure.style.line_width = read_line_width(texts.line_width);
  if (!texts.background.empty()) call.figure.ground = read_colour(texts.background);
  if (is_transparent && call.figure.ground)
    throw Error("--background and --transparent exclude each other");
  if (call.figure.samples < 1) throw Error("--samples takes a number of 1 or more");
  if (is_transparent) call.figure.style.background = Background::transparent;
}

EditorPictureCall editor_picture(const Texts& texts, const RenderCall& call) {
  EditorPictureCall picture{call.file, call.picture, {}, {}};
  if (!texts.size.empty()) picture.size = read_size(texts.size);
  if (!texts.theme.empty()) picture.theme = read_theme(texts.theme);
  return picture;
}

void read_animate(const Texts& texts, bool is_transparent, AnimateCall& call) {
  if (!find_animation_format(call.output))
    throw Error(call.output.string() + ": animate writes " + animation_endings());
  RenderCall look;
  look.figure = call.figure;
  read_render(texts, is_transparent, look);
  call.figure = look.figure;
  if (!texts.layers.empty()) call.layers = look.figure.style.layers;
  if (!texts.size.empty()) call.size = read_size(texts.size);
  if (!texts.fps.empty()) {
    call.fps = parse_number(texts.fps);
    if (!call.fps || !(*call.fps >= kLeastFps && *call.fps <= kLargestFps))
      throw Error("--fps takes a number from 0.1 to 1000, not " + in_quotes(texts.fps));
  }
  if (!texts.range.empty()) call.range = read_range(texts.range);
  if (!(call.tolerance > 0)) throw Error("--bake-tolerance takes a number above 0");
}

void read_check(const CheckCall& call) {
  if (call.deformed.empty() && call.rest.extension() != ".foldless")
    throw Error(call.rest.string() +
                ": check needs DEFORMED too, the same triangles deformed, or a baked animation "
                "(.foldless)");
}

namespace {

void read_sweep(const Texts& texts, BenchCall& call) {
  if (!texts.shard.empty()) call.shard = read_shard(texts.shard);
  if (!call.shard && !call.append) return;
  if (call.merge) throw Error("--merge runs nothing: leave out --shard and --append");
  if (!call.suite.empty() && call.suite != "random" && call.suite != "hard")
    throw Error("--shard and --append go with scene files, --suite random or --suite hard");
}

}  // namespace

void read_bench(const Texts& texts, BenchCall& call) {
  constexpr std::array<std::string_view, 6> kSuites{"", "random", "hard", "paper", "scale", "drag"};
  if (std::ranges::find(kSuites, call.suite) == kSuites.end())
    throw Error("--suite " + in_quotes(call.suite) +
                " is unknown; choose random, hard, paper, scale or drag");
  if (call.merge && (!call.suite.empty() || call.scenes.empty()))
    throw Error("--merge takes the files that --append wrote, and no suite");
  if (call.suite.empty() == call.scenes.empty())
    throw Error("bench takes either scene files or --suite random|hard|paper|scale|drag");
  for (const std::string& name : items_of(texts.methods))
    if (!name.empty()) {
      expect_name("--method", name, methods());
      call.methods.push_back(name);
    }
  for (const std::string& index : items_of(texts.only)) {
    if (index.empty()) continue;
    const auto number = parse_integer(index);
    if (!number || *number < 0)
      throw Error("--only takes indices of scenes, from 0, not " + in_quotes(index));
    call.only.push_back(*number);
  }
  read_sweep(texts, call);
  if (call.count < 1) throw Error("--count takes a number of 1 or more");
  if (call.options.threads < 1) throw Error("--jobs takes a number of 1 or more");
  if (call.options.team < 1) throw Error("--threads takes a number of 1 or more");
  if (call.options.repeat < 1) throw Error("--repeat takes a number of 1 or more");
  if (!(call.options.time_limit > 0)) throw Error("--time-limit takes a number above 0");
}

}  // namespace foldless
