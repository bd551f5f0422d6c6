// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/cli/calls.h"
#include "app/cli/option_texts.h"

namespace foldless {

/// The flags of `render` that are no values.
struct RenderFlags {
  bool is_transparent = false;
  bool is_of_editor = false;
};

// Each adds one subcommand, whose options go into the call and the texts; they have to outlive it.

CLI::App* add_solve(CLI::App& app, SolveCall& call, Texts& texts);
CLI::App* add_animate(CLI::App& app, AnimateCall& call, Texts& texts, RenderFlags& flags);
CLI::App* add_render(CLI::App& app, RenderCall& call, Texts& texts, RenderFlags& flags);
CLI::App* add_mesh(CLI::App& app, MeshCall& call);
CLI::App* add_check(CLI::App& app, CheckCall& call);
CLI::App* add_compare(CLI::App& app, CompareCall& call);
CLI::App* add_replay(CLI::App& app, ReplayCall& call, Texts& texts);
CLI::App* add_bench(CLI::App& app, BenchCall& call, Texts& texts);

/// With which the help of a subcommand ends, or of the program where the name is empty; it can be
/// pasted.
std::string example_of(const std::string& subcommand, const std::string& program);

}  // namespace foldless
