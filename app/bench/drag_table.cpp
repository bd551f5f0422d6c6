// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/drag_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/files/text_lines.h"
#include "core/scene/json_object.h"

namespace foldless {
namespace {

std::string digits(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

std::string milliseconds(double seconds) { return number_text(1e3 * seconds); }

/// A number of one run of drag.csv and drag.json.
struct DragColumn {
  const char* name;
  double (*value)(const BenchRow& row, const DragSummary& summary);
};

constexpr std::array kDragColumns{
    DragColumn{"vertices",
               [](const BenchRow& row, const DragSummary&) { return double(row.vertices); }},
    DragColumn{"faces", [](const BenchRow& row, const DragSummary&) { return double(row.faces); }},
    DragColumn{"frames",
               [](const BenchRow& row, const DragSummary&) { return double(row.frames.size()); }},
    DragColumn{"first_median_seconds",
               [](const BenchRow&, const DragSummary& s) { return s.median_first_seconds; }},
    DragColumn{"first_p95_seconds",
               [](const BenchRow&, const DragSummary& s) { return s.p95_first_seconds; }},
    DragColumn{"frame_median_seconds",
               [](const BenchRow&, const DragSummary& s) { return s.median_seconds; }},
    DragColumn{"frame_p95_seconds",
               [](const BenchRow&, const DragSummary& s) { return s.p95_seconds; }},
    DragColumn{"distance_p95",
               [](const BenchRow&, const DragSummary& s) { return s.p95_distance; }},
    DragColumn{"factorizations_a_frame",
               [](const BenchRow&, const DragSummary& s) { return s.factorizations; }},
    DragColumn{"iterations_a_frame",
               [](const BenchRow&, const DragSummary& s) { return s.iterations; }},
    DragColumn{"invalid_frames",
               [](const BenchRow&, const DragSummary& s) { return double(s.invalid); }},
};

}  // namespace

double percentile(std::vector<double> values, double p) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  const auto rank = static_cast<std::size_t>(std::ceil(p * static_cast<double>(values.size())));
  return values[std::clamp<std::size_t>(rank, 1, values.size()) - 1];
}

DragSummary drag_summary(const BenchRow& row) {
  DragSummary summary;
  std::vector<double> first, whole, distances;
  for (const DragFrame& frame : row.frames) {
    first.push_back(frame.first_seconds);
    whole.push_back(frame.seconds);
    distances.push_back(frame.distance / row.diagonal);
    summary.factorizations += frame.factorizations;
    summary.iterations += frame.iterations;
    summary.invalid += frame.is_valid ? 0 : 1;
  }
  if (row.frames.empty()) return summary;
  summary.factorizations /= static_cast<double>(row.frames.size());
  summary.iterations /= static_cast<double>(row.frames.size());
  summary.median_first_seconds = percentile(first, 0.5);
  summary.p95_first_seconds = percentile(std::move(first), 0.95);
  summary.median_seconds = percentile(whole, 0.5);
  summary.p95_seconds = percentile(std::move(whole), 0.95);
  summary.p95_distance = percentile(std::move(distances), 0.95);
  return summary;
}

TextTable drag_table(std::span<const BenchRow> rows) {
  TextTable table({"drag", "V/F", "method", "frames", "first ms", "p95", "frame ms", "p95", "U",
                   "H", "off by p95 [D]", "valid"});
  for (const BenchRow& row : rows) {
    const DragSummary s = drag_summary(row);
    const bool is_valid = row.is_valid && s.invalid == 0;
    table.add({row.scene, std::to_string(row.vertices) + "/" + std::to_string(row.faces),
               row.method, std::to_string(row.frames.size()), milliseconds(s.median_first_seconds),
               milliseconds(s.p95_first_seconds), milliseconds(s.median_seconds),
               milliseconds(s.p95_seconds), number_text(s.iterations),
               number_text(s.factorizations), number_text(s.p95_distance, 2),
               is_valid ? "yes" : "no"});
  }
  return table;
}

TextTable drag_csv_table(std::span<const BenchRow> rows) {
  std::vector<std::string> titles{"drag", "energy", "method", "outcome", "valid"};
  for (const DragColumn& column : kDragColumns) titles.emplace_back(column.name);
  TextTable table(std::move(titles));
  for (const BenchRow& row : rows) {
    std::vector<std::string> cells{row.scene, row.energy, row.method, row.outcome,
                                   row.is_valid ? "yes" : "no"};
    const DragSummary summary = drag_summary(row);
    for (const DragColumn& column : kDragColumns)
      cells.push_back(digits(column.value(row, summary)));
    table.add(std::move(cells));
  }
  return table;
}

JsonNode drag_node(std::span<const BenchRow> rows) {
  JsonNode::Array array;
  for (const BenchRow& row : rows) {
    JsonNode::Object object = object_of(
        JsonMember("drag", JsonNode{row.scene}), JsonMember("energy", JsonNode{row.energy}),
        JsonMember("method", JsonNode{row.method}), JsonMember("outcome", JsonNode{row.outcome}),
        JsonMember("valid", JsonNode{row.is_valid}));
    const DragSummary summary = drag_summary(row);
    for (const DragColumn& column : kDragColumns)
      object.emplace_back(column.name, JsonNode{column.value(row, summary)});
    array.push_back({std::move(object)});
  }
  return {std::move(array)};
}

TextTable drag_frames_table(std::span<const BenchRow> rows) {
  TextTable table({"drag", "method", "frame", "first_seconds", "seconds", "iterations",
                   "factorizations", "distance", "valid"});
  for (const BenchRow& row : rows)
    for (std::size_t i = 0; i < row.frames.size(); ++i) {
      const DragFrame& frame = row.frames[i];
      table.add({row.scene, row.method, std::to_string(i), digits(frame.first_seconds),
                 digits(frame.seconds), std::to_string(frame.iterations),
                 std::to_string(frame.factorizations), digits(frame.distance / row.diagonal),
                 frame.is_valid ? "yes" : "no"});
    }
  return table;
}

}  // namespace foldless
