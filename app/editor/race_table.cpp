// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/race_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <initializer_list>
#include <vector>

#include "core/error.h"
#include "core/files/iterations_csv.h"
#include "core/files/latex_table.h"
#include "core/files/text_lines.h"

namespace foldless {
namespace {

constexpr std::string_view kTableColumns =
    "lane,mesh,vertices,triangles,energy,method,delta,eta,conformal_distortion_max,"
    "conformal_distortion_mean,handle_error_squared,CI,H,U,seconds,flips,splits,inverted\n";

/// A field that holds any words.
std::string csv_field(std::string_view words) {
  std::string text = "\"";
  for (const char c : words) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + '"';
}

template <typename Number>
void append_numbers(std::string& text, std::initializer_list<Number> numbers) {
  for (const Number number : numbers) {
    text += ',';
    append_number(text, number);
  }
}

void append_row(std::string& text, const RaceLane& lane, const Document& document) {
  const Iteration record = lane.record() ? *lane.record() : Iteration{};
  text += csv_field(lane.title()) + ',' + csv_field(document.name);
  append_numbers(text, {lane.proof().vertices, lane.proof().triangles});
  text.append(",").append(lane.energy().name).append(",").append(lane.parameters().method);
  append_numbers(
      text, {lane.parameters().delta, lane.parameters().eta, lane.proof().max_conformal_distortion,
             record.mean_conformal_distortion, record.handle_error_squared});
  text.append(",").append(convergence_letter(lane));
  append_numbers(text, {record.factorizations, record.updates});
  append_numbers(text, {record.seconds});
  append_numbers(text, {record.flips, record.splits, lane.proof().inverted});
  text += '\n';
}

std::string three_digits(double value) {
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 3);
  return {text.data(), end.ptr};
}

}  // namespace

std::string_view convergence_letter(const RaceLane& lane) {
  if (!lane.is_at_end() || !lane.outcome()) return "–";
  switch (*lane.outcome()) {
    case Outcome::gradient: return "G";
    case Outcome::step: return "S";
    default: return "M";
  }
}

std::vector<std::optional<int>> race_places(const Race& race) {
  const auto& lanes = race.lanes();
  const auto arrived = [](const RaceLane& lane) {
    return lane.is_at_end() && lane.is_at_targets() && !lane.proof().folds() && lane.record();
  };
  std::vector<std::optional<int>> places(lanes.size());
  for (std::size_t i = 0; i < lanes.size(); ++i)
    if (arrived(*lanes[i]))
      places[i] =
          1 + static_cast<int>(std::ranges::count_if(lanes, [&](const auto& other) {
            return arrived(*other) && other->record()->seconds < lanes[i]->record()->seconds;
          }));
  return places;
}

std::string race_table_csv(const Race& race) {
  std::string text(kTableColumns);
  for (const auto& lane : race.lanes()) append_row(text, *lane, race.document());
  return text;
}

std::string race_table_latex(const Race& race) {
  std::vector<std::vector<std::string>> rows{{"lane", "method", "δ", "η", "largest", "mean", "‖P‖²",
                                              "CI", "H", "U", "seconds", "flips", "splits",
                                              "inverted"}};
  for (const auto& lane : race.lanes()) {
    const Iteration record = lane->record() ? *lane->record() : Iteration{};
    rows.push_back(
        {lane->title(), lane->parameters().method, three_digits(lane->parameters().delta),
         three_digits(lane->parameters().eta), three_digits(lane->proof().max_conformal_distortion),
         three_digits(record.mean_conformal_distortion), three_digits(record.handle_error_squared),
         std::string(convergence_letter(*lane)), std::to_string(record.factorizations),
         std::to_string(record.updates), three_digits(record.seconds), std::to_string(record.flips),
         std::to_string(record.splits), std::to_string(lane->proof().inverted)});
  }
  return latex_table(rows);
}

bool is_latex_table(const std::filesystem::path& file) {
  if (file.extension() == ".tex") return true;
  if (file.extension() == ".csv") return false;
  throw Error(file.string() +
              ": tables are written as CSV or LaTeX; end the name with .csv or .tex");
}

std::string race_records_csv(const Race& race) {
  std::string text = "lane," + iteration_columns() + '\n';
  for (const auto& lane : race.lanes()) {
    const std::size_t count = std::min(lane->records().size(), race.furthest());
    for (std::size_t i = 0; i < count; ++i) {
      text += csv_field(lane->title()) + ',';
      append_iteration(text, lane->records()[i]);
      text += '\n';
    }
  }
  return text;
}

}  // namespace foldless
