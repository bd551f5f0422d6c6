// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/paper_suite.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "app/export/svg_plot.h"
#include "core/data_path.h"
#include "core/method/methods.h"
#include "core/scene/scene_io.h"

namespace foldless {
namespace {

BenchScene scene_of(std::string_view name) {
  const auto file = data_path("assets/scenes/" + std::string(name) + ".json");
  return {std::string(name), "", load_scene(file, method_names()).scene};
}

Parameters parameters_of(const PaperRow& row, Parameters parameters) {
  parameters.method = row.method;
  parameters.delta = row.delta;
  if (row.eta) parameters.eta = *row.eta;
  parameters.condition_test = row.condition_test;
  if (row.distortion_bound) parameters.distortion_bound = *row.distortion_bound;
  parameters.start = row.start;
  return parameters;
}

bool contains(std::span<const std::string> names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

/// The letter of the paper's column CI.
std::string convergence_of(const BenchRow& row) {
  if (row.outcome == "gradient") return "G";
  if (row.outcome == "step") return "S";
  return row.outcome == "refused" ? "—" : "M";
}

std::string or_dash(const std::optional<double>& value, int digits = 3) {
  return value ? number_text(*value, digits) : "—";
}

std::string pair_text(const std::string& a, const std::string& b) {
  return a == "—" && b == "—" ? "—" : a + "/" + b;
}

std::string or_dash(const std::optional<int>& value) {
  return value ? std::to_string(*value) : "—";
}

/// `figure5_coarse_disk` → `Coarse disk`.
std::string title_of(std::string_view scene) {
  std::string title(scene.substr(scene.find('_') + 1));
  std::ranges::replace(title, '_', ' ');
  if (!title.empty() && title[0] >= 'a' && title[0] <= 'z')
    title[0] = static_cast<char>(title[0] - 'a' + 'A');
  return title;
}

/// M/A.
std::string distortions_of(const BenchRow& run) {
  if (!run.is_valid) return "folded";
  return number_text(run.max_conformal_distortion) + "/" +
         number_text(run.mean_conformal_distortion);
}

/// δ/η, or the bound of the methods that have one.
std::string knobs_of(const PaperRow& row) {
  if (row.distortion_bound) return "K " + number_text(*row.distortion_bound);
  return number_text(row.delta, 1) + "/" + (row.eta ? number_text(*row.eta, 1) : "No");
}

std::vector<std::string> cells_of(const PaperRow& row, const BenchRow& run) {
  const PaperFigures& paper = row.paper;
  return {title_of(run.scene) + " (" + std::to_string(run.vertices) + "V/" +
              std::to_string(run.faces) + "F; " + run.energy + ")",
          std::string(row.label),
          std::string(row.method),
          knobs_of(row),
          distortions_of(run),
          number_text(run.handle_error_squared, 2),
          convergence_of(run),
          std::to_string(run.last.factorizations) + "/" + std::to_string(run.last.updates),
          number_text(run.seconds, 2),
          pair_text(or_dash(paper.max_distortion), or_dash(paper.mean_distortion)),
          or_dash(paper.handle_error_squared, 2),
          paper.convergence == 0 ? "—" : std::string(1, paper.convergence),
          pair_text(or_dash(paper.factorizations), or_dash(paper.updates)),
          or_dash(paper.seconds, 2)};
}

/// A curve of Figure 13, in the paper's colours.
struct Curve {
  std::string_view method;
  bool condition_test;
  const char* name;
  const char* colour;
};

constexpr std::array kCurves{
    Curve{"lim", true, "[SKPSH13]", "#d62728"},
    Curve{"paper-noflip", true, "without flips", "#2ca02c"},
    Curve{"paper-flip", true, "with flips", "#1f77b4"},
    Curve{"paper-flip", false, "flips without eq. 10", "#222222"},
};

struct Quantity {
  const char* name;
  const char* label;
  double Iteration::*value;
};

constexpr std::array kQuantities{
    Quantity{"energy", "E", &Iteration::energy},
    Quantity{"gradient", "‖∇E‖²", &Iteration::gradient_norm_squared},
};

struct Disk {
  std::string_view scene;
  const char* name;  ///< in file names
  const char* title;
};

constexpr std::array kDisks{
    Disk{"figure5_coarse_disk", "coarse_disk", "coarse disk"},
    Disk{"figure6_dense_disk", "dense_disk", "dense disk"},
};

/// The first run of a curve's method on a scene: Table 1 begins with the default parameters.
const BenchRow* run_of(const Curve& curve, std::string_view scene, std::span<const BenchRow> rows) {
  const auto found = std::ranges::find_if(rows, [&](const BenchRow& row) {
    return row.scene == scene && row.method == curve.method &&
           row.parameters.condition_test == curve.condition_test && !row.iterations.empty();
  });
  return found == rows.end() ? nullptr : &*found;
}

std::string plot_of(const Quantity& quantity, const Disk& disk, std::span<const BenchRow> rows) {
  std::vector<Series> series;
  for (const Curve& curve : kCurves) {
    const BenchRow* run = run_of(curve, disk.scene, rows);
    if (run == nullptr) continue;
    Series& line = series.emplace_back();
    line.name = curve.name;
    line.colour = curve.colour;
    for (const Iteration& record : run->iterations) line.y.push_back(record.*quantity.value);
  }
  if (series.empty()) return "";
  return svg_plot(series, {.title = std::string(quantity.label) + ", " + disk.title,
                           .x = {"vertex update"},
                           .y = {quantity.label, true}});
}

}  // namespace

PaperSuite paper_suite(std::span<const std::string> wanted) {
  PaperSuite suite;
  std::vector<const PaperRow*> rows;
  for (const PaperRow& row : paper_rows()) {
    if (!wanted.empty() && !contains(wanted, row.method)) continue;
    if (find_method(row.method) != nullptr)
      rows.push_back(&row);
    else if (!contains(suite.left_out, row.method))
      suite.left_out.emplace_back(row.method);
  }
  for (const PaperRow* row : rows)
    if (suite.scenes.empty() || suite.scenes.back().name != row->scene)
      suite.scenes.push_back(scene_of(row->scene));
  for (const PaperRow* row : rows) {
    const auto scene = std::ranges::find(suite.scenes, row->scene, &BenchScene::name);
    suite.jobs.push_back({&*scene, parameters_of(*row, scene->scene.parameters)});
    suite.rows.push_back(row);
  }
  return suite;
}

TextTable table1(const PaperSuite& suite, std::span<const BenchRow> rows) {
  TextTable table({"Mesh/Energy", "Method", "Name", "δ/η", "M/A", "‖P‖²", "CI", "H/U", "Time(s)",
                   "paper: M/A", "‖P‖²", "CI", "H/U", "Time(s)"});
  for (const BenchRow& row : rows) table.add(cells_of(*suite.rows[row.job], row));
  return table;
}

std::vector<PlotFile> figure13(std::span<const BenchRow> rows) {
  std::vector<PlotFile> files;
  for (const Disk& disk : kDisks)
    for (const Quantity& quantity : kQuantities) {
      std::string svg = plot_of(quantity, disk, rows);
      if (!svg.empty())
        files.push_back(
            {std::string("figure13_") + disk.name + "_" + quantity.name + ".svg", std::move(svg)});
    }
  return files;
}

}  // namespace foldless
