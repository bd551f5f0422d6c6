// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "app/cli/calls.h"

namespace foldless {

/// A number option that sets a parameter.
struct NumberOption {
  const char* flag;
  std::string_view key;
  const char* help;
};

inline constexpr std::array kNumberOptions{
    NumberOption{"--alpha", "alpha", "weight of the penalty for handles off their targets"},
    NumberOption{"--beta", "beta", "weight of the barrier against inversion"},
    NumberOption{"--delta", "delta", "smallest area ratio of a triangle, in (0, 1)"},
    NumberOption{"--eta", "eta", "smallest relative decrease of energy that flips an edge"},
    NumberOption{"--inner", "inner_iterations", "most iterations of the inner loop"},
    NumberOption{"--outer", "outer_iterations", "most rounds of the outer loop"},
    NumberOption{"--bound", "distortion_bound",
                 "bound K of \u03c3\u2081/\u03c3\u2082, for methods that have one"},
};

/// The names of rows, separated by commas.
template <typename Rows>
std::string names_of(const Rows& rows) {
  std::string names;
  for (const auto& row : rows) names += (names.empty() ? "" : ", ") + std::string(row.name);
  return names;
}

std::string words_of(std::span<const std::string_view> words);

/// The options of one call as text, until they are read.
struct Texts {
  std::string frames, start, time_limit, size, view, layers, methods, only, shard;
  std::string fps, range;                             // of animate
  std::string theme, background, camera, line_width;  // of render
  std::array<std::string, kNumberOptions.size()> numbers;
};

/// What the texts say goes into the call. Throws Error, one sentence that names the option, where a
/// text or a value of the call is not allowed.
void read_solve(const Texts& texts, SolveCall& call);
/// `1200x900`: width and height.
std::array<int, 2> read_size(const std::string& text);
void read_render(const Texts& texts, bool is_transparent, RenderCall& call);
/// Of --ui.
EditorPictureCall editor_picture(const Texts& texts, const RenderCall& call);
/// Throws Error, besides, for an output of a kind that is not written.
void read_animate(const Texts& texts, bool is_transparent, AnimateCall& call);
void read_check(const CheckCall& call);
void read_bench(const Texts& texts, BenchCall& call);

}  // namespace foldless
