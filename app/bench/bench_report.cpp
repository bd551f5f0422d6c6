// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/bench_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "app/bench/best_energy.h"
#include "core/files/text_lines.h"

namespace foldless {
namespace {

std::string size_text(const BenchRow& row) {
  return std::to_string(row.vertices) + "/" + std::to_string(row.faces);
}

std::string yes_or_no(bool value) { return value ? "yes" : "no"; }

/// A column of results.csv and results.json.
struct Column {
  const char* name;
  JsonNode (*value)(const BenchRow& row);
};

JsonNode number(double value) {
  if (!std::isfinite(value)) return {nullptr};
  return {value};
}

constexpr std::array kColumns{
    Column{"scene", [](const BenchRow& row) { return JsonNode{row.scene}; }},
    Column{"difficulty", [](const BenchRow& row) { return JsonNode{row.difficulty}; }},
    Column{"vertices", [](const BenchRow& row) { return number(row.vertices); }},
    Column{"faces", [](const BenchRow& row) { return number(row.faces); }},
    Column{"energy", [](const BenchRow& row) { return JsonNode{row.energy}; }},
    Column{"method", [](const BenchRow& row) { return JsonNode{row.method}; }},
    Column{"delta", [](const BenchRow& row) { return number(row.parameters.delta); }},
    Column{"eta", [](const BenchRow& row) { return number(row.parameters.eta); }},
    Column{"reached", [](const BenchRow& row) { return JsonNode{row.has_reached()}; }},
    Column{"satisfied", [](const BenchRow& row) { return JsonNode{row.is_satisfied}; }},
    Column{"valid", [](const BenchRow& row) { return JsonNode{row.is_valid}; }},
    Column{"outcome", [](const BenchRow& row) { return JsonNode{row.outcome}; }},
    Column{"factorizations", [](const BenchRow& row) { return number(row.last.factorizations); }},
    Column{"updates", [](const BenchRow& row) { return number(row.last.updates); }},
    Column{"flips", [](const BenchRow& row) { return number(row.last.flips); }},
    Column{"splits", [](const BenchRow& row) { return number(row.last.splits); }},
    Column{"vertices_added", [](const BenchRow& row) { return number(row.vertices_added); }},
    Column{"seconds", [](const BenchRow& row) { return number(row.seconds); }},
    Column{"conformal_distortion_max",
           [](const BenchRow& row) { return number(row.max_conformal_distortion); }},
    Column{"conformal_distortion_mean",
           [](const BenchRow& row) { return number(row.mean_conformal_distortion); }},
    Column{"E_d", [](const BenchRow& row) { return number(row.distortion_energy); }},
    Column{"handle_error_squared",
           [](const BenchRow& row) { return number(row.handle_error_squared); }},
    Column{"diagonal", [](const BenchRow& row) { return number(row.diagonal); }},
    Column{"overlapping_boundary_vertices",
           [](const BenchRow& row) { return number(row.overlapping_boundary_vertices); }},
    Column{"note", [](const BenchRow& row) { return JsonNode{row.note}; }},
};

/// The last one, which belongs to all rows of a scene together.
constexpr const char* kRatioColumn = "E_d_ratio_to_best";

std::string cell_of(const JsonNode& node) {
  if (const auto* text = node.as<std::string>()) return *text;
  if (const bool* flag = node.as<bool>()) return yes_or_no(*flag);
  std::string text;
  if (const double* value = node.as<double>()) append_number(text, *value);
  return text;
}

std::vector<std::string> methods_of(std::span<const BenchRow> rows) {
  std::vector<std::string> methods;
  for (const BenchRow& row : rows)
    if (std::ranges::find(methods, row.method) == methods.end()) methods.push_back(row.method);
  return methods;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  return values[values.size() / 2];
}

/// E_d that is at most so many times the least counts as good as that.
constexpr double kNearBest = 1.02;

/// Ratios that a run of no work at all does not spoil.
double log_ratio(double a, double b, double least) {
  return std::log(std::max(a, least) / std::max(b, least));
}

void compare(std::span<const BenchRow> rows, const std::string& first, MethodSummary& summary) {
  std::map<std::string, const BenchRow*> reference;
  for (const BenchRow& row : rows)
    if (row.method == first && row.has_reached()) reference[row.scene] = &row;
  double factorizations = 0;
  double seconds = 0;
  for (const BenchRow& row : rows) {
    if (row.method != summary.method || !row.has_reached()) continue;
    const auto other = reference.find(row.scene);
    if (other == reference.end()) continue;
    ++summary.shared;
    factorizations += log_ratio(row.last.factorizations, other->second->last.factorizations, 1);
    seconds += log_ratio(row.seconds, other->second->seconds, 1e-6);
  }
  if (summary.shared == 0) return;
  summary.factorization_ratio = std::exp(factorizations / summary.shared);
  summary.seconds_ratio = std::exp(seconds / summary.shared);
}

}  // namespace

TextTable rows_table(std::span<const BenchRow> rows) {
  TextTable table({"scene", "V/F", "energy", "method", "reached", "outcome", "H/U", "flips",
                   "splits", "CPU s", "max", "mean", "E_d", "P²/D²", "valid", "V added"});
  for (const BenchRow& row : rows)
    table.add({row.scene, size_text(row), row.energy, row.method, yes_or_no(row.has_reached()),
               row.outcome,
               std::to_string(row.last.factorizations) + "/" + std::to_string(row.last.updates),
               std::to_string(row.last.flips), std::to_string(row.last.splits),
               number_text(row.seconds), number_text(row.max_conformal_distortion),
               number_text(row.mean_conformal_distortion), number_text(row.distortion_energy),
               number_text(row.relative_handle_error(), 2), yes_or_no(row.is_valid),
               std::to_string(row.vertices_added)});
  return table;
}

TextTable rows_csv_table(std::span<const BenchRow> rows) {
  std::vector<std::string> titles;
  titles.reserve(kColumns.size() + 1);
  for (const Column& column : kColumns) titles.emplace_back(column.name);
  titles.emplace_back(kRatioColumn);
  TextTable table(std::move(titles));
  const BestEnergies best(rows);
  for (const BenchRow& row : rows) {
    std::vector<std::string> cells;
    cells.reserve(kColumns.size() + 1);
    for (const Column& column : kColumns) cells.push_back(cell_of(column.value(row)));
    cells.push_back(cell_of(number(best.ratio(row))));
    table.add(std::move(cells));
  }
  return table;
}

JsonNode rows_node(std::span<const BenchRow> rows) {
  JsonNode::Array array;
  const BestEnergies best(rows);
  for (const BenchRow& row : rows) {
    JsonNode::Object object;
    for (const Column& column : kColumns) object.emplace_back(column.name, column.value(row));
    object.emplace_back(kRatioColumn, number(best.ratio(row)));
    array.push_back({std::move(object)});
  }
  return {std::move(array)};
}

std::vector<MethodSummary> summaries_of(std::span<const BenchRow> rows) {
  std::vector<MethodSummary> summaries;
  const std::vector<std::string> methods = methods_of(rows);
  const BestEnergies best(rows);
  for (const std::string& method : methods) {
    MethodSummary summary{.method = method};
    std::vector<double> seconds;
    for (const BenchRow& row : rows) {
      if (row.method != method) continue;
      ++summary.runs;
      summary.reached += row.has_reached() ? 1 : 0;
      const double ratio = best.ratio(row);
      summary.near_best += ratio <= kNearBest ? 1 : 0;
      if (ratio > summary.largest_energy_ratio) summary.largest_energy_ratio = ratio;
      summary.invalid += !row.is_valid && row.outcome != "refused" ? 1 : 0;
      summary.factorizations += row.last.factorizations;
      summary.updates += row.last.updates;
      summary.seconds += row.seconds;
      seconds.push_back(row.seconds);
    }
    summary.median_seconds = median(std::move(seconds));
    compare(rows, methods.front(), summary);
    summaries.push_back(std::move(summary));
  }
  return summaries;
}

TextTable summary_table(std::span<const MethodSummary> summaries) {
  const std::string first = summaries.empty() ? "first" : summaries.front().method;
  TextTable table({"method", "reached", "invalid", "H", "U", "CPU s", "median s",
                   "shared with " + first, "H ratio", "CPU ratio", "E_d near best",
                   "largest E_d ratio"});
  for (const MethodSummary& summary : summaries)
    table.add({summary.method, std::to_string(summary.reached) + "/" + std::to_string(summary.runs),
               std::to_string(summary.invalid), std::to_string(summary.factorizations),
               std::to_string(summary.updates), number_text(summary.seconds),
               number_text(summary.median_seconds), std::to_string(summary.shared),
               number_text(summary.factorization_ratio), number_text(summary.seconds_ratio),
               std::to_string(summary.near_best) + "/" + std::to_string(summary.reached),
               number_text(summary.largest_energy_ratio)});
  return table;
}

TextTable difficulty_table(std::span<const BenchRow> rows) {
  const std::vector<std::string> methods = methods_of(rows);
  std::vector<std::string> titles{"reached"};
  titles.insert(titles.end(), methods.begin(), methods.end());
  TextTable table(std::move(titles));
  std::vector<std::string> difficulties;
  std::map<std::pair<std::string, std::string>, std::pair<int, int>> counts;
  for (const BenchRow& row : rows) {
    if (row.difficulty.empty()) continue;
    if (std::ranges::find(difficulties, row.difficulty) == difficulties.end())
      difficulties.push_back(row.difficulty);
    auto& [reached, runs] = counts[{row.difficulty, row.method}];
    reached += row.has_reached() ? 1 : 0;
    ++runs;
  }
  for (const std::string& difficulty : difficulties) {
    std::vector<std::string> cells{difficulty};
    for (const std::string& method : methods) {
      const auto [reached, runs] = counts[{difficulty, method}];
      cells.push_back(std::to_string(reached) + "/" + std::to_string(runs));
    }
    table.add(std::move(cells));
  }
  return table;
}

}  // namespace foldless
