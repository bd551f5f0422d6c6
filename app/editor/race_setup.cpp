// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/race_setup.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <string_view>
#include <utility>

#include "app/editor/edits.h"
#include "core/energy/densities.h"
#include "core/method/methods.h"
#include "core/scene/scene_io.h"

namespace foldless {
namespace {

double stepped(const ParameterRow& row, double value, int steps) {
  for (; steps > 0; --steps)
    value =
        row.scale == ParameterScale::linear ? value + (row.maximum - row.minimum) / 10 : value * 10;
  return std::clamp(value, row.minimum, row.maximum);
}

std::string value_of(const ParameterRow& row, double value) {
  if (row.scale == ParameterScale::on_off) return value != 0 ? "on" : "off";
  std::array<char, 32> number{};
  std::snprintf(number.data(), number.size(), "%.6g", value);
  return number.data();
}

std::string title_of(const ParameterRow& row, double value) {
  const std::string title(row.title);
  if (row.scale == ParameterScale::on_off) return title + ": " + value_of(row, value);
  // The letter of the paper is enough: "η = 0.001".
  const auto space = title.rfind(' ');
  const bool has_letter = space != std::string::npos && title.size() - space <= 3;
  return (has_letter ? title.substr(space + 1) : title) + " = " + value_of(row, value);
}

/// "Flips" of "Remeshing-assisted, flips": what stands before the comma is common to variants.
std::string variant_of(std::string_view title) {
  const auto comma = title.find(", ");
  if (comma == std::string_view::npos) return std::string(title);
  std::string words(title.substr(comma + 2));
  words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
  return words;
}

/// The first energy that no lane has yet, or the first of all.
const Density* unused_energy(const std::vector<const Density*>& used) {
  for (const Density& density : densities())
    if (std::ranges::find(used, &density) == used.end()) return &density;
  return &densities().front();
}

/// The first method that no lane has yet, or the first of all.
std::string unused_method(const std::vector<std::string>& used) {
  for (const MethodRow& row : methods())
    if (std::ranges::find(used, row.name) == used.end()) return std::string(row.name);
  return std::string(methods().front().name);
}

/// Numbers what is called as an entry before it: "Flips (2)".
void make_unique(std::vector<RaceEntry>& entries, std::string RaceEntry::*name) {
  for (auto entry = entries.begin(); entry != entries.end(); ++entry) {
    const auto is_taken = [&](const std::string& words) {
      return std::any_of(entries.begin(), entry,
                         [&](const RaceEntry& other) { return other.*name == words; });
    };
    const std::string words = (*entry).*name;
    for (int number = 2; is_taken((*entry).*name); ++number)
      (*entry).*name = words + " (" + std::to_string(number) + ')';
  }
}

}  // namespace

RaceScene load_race_scene(const std::filesystem::path& file) {
  const Scene scene = load_scene(file, method_names()).scene;
  return {file, scene.parameters, scene.energy};
}

RaceSetup method_race(const Document& document) {
  RaceSetup setup;
  setup.methods.push_back(document.parameters.method);
  const std::size_t count = std::clamp(methods().size(), kFewestLanes, kMostLanes);
  while (setup.methods.size() < count) setup.methods.push_back(unused_method(setup.methods));
  return setup;
}

RaceSetup energy_race(const Document& document) {
  RaceSetup setup;
  setup.energies.push_back(document.energy);
  const std::size_t count = std::clamp(densities().size(), kFewestLanes, kMostLanes);
  while (setup.energies.size() < count) setup.energies.push_back(unused_energy(setup.energies));
  return setup;
}

RaceSetup parameter_race(const ParameterRow& row, const Document& document) {
  RaceSetup setup;
  setup.varied = &row;
  const double value = default_of(row, document.parameters, *document.energy);
  if (row.scale == ParameterScale::on_off) {
    setup.values = {1, 0};
  } else {
    for (int steps = 0; steps < 3; ++steps) setup.values.push_back(stepped(row, value, steps));
  }
  return setup;
}

RaceSetup with_lane(RaceSetup setup) {
  if (setup.lane_count() >= kMostLanes) return setup;
  if (setup.varied)
    setup.values.push_back(stepped(*setup.varied, setup.values.back(), 1));
  else if (setup.varies_energy())
    setup.energies.push_back(unused_energy(setup.energies));
  else
    setup.methods.push_back(unused_method(setup.methods));
  return setup;
}

RaceSetup without_lane(RaceSetup setup) {
  if (setup.lane_count() <= kFewestLanes) return setup;
  if (setup.varied)
    setup.values.pop_back();
  else if (setup.varies_energy())
    setup.energies.pop_back();
  else
    setup.methods.pop_back();
  setup.scenes.erase(setup.lane_count());
  return setup;
}

std::vector<RaceEntry> entries_of(const RaceSetup& setup, const Document& document) {
  std::vector<RaceEntry> entries;
  const auto add = [&](std::string title, std::string short_title) -> RaceEntry& {
    return entries.emplace_back(
        RaceEntry{std::move(title), std::move(short_title), document.parameters, document.energy});
  };
  for (const double value : setup.values)
    setup.varied->set(
        add(title_of(*setup.varied, value), value_of(*setup.varied, value)).parameters, value);
  for (const Density* energy : setup.energies)
    add(std::string(energy->title), std::string(energy->title)).energy = energy;
  for (const std::string& name : setup.methods) {
    const MethodRow* method = find_method(name);
    const std::string title = method ? std::string(method->title) : name;
    add(title, variant_of(title)).parameters.method = name;
  }
  for (const auto& [lane, scene] : setup.scenes) {
    const std::string name = scene.file.stem().string();
    entries.at(lane) = {name, name, scene.parameters, scene.energy};
  }
  make_unique(entries, &RaceEntry::title);
  make_unique(entries, &RaceEntry::short_title);
  return entries;
}

Document start_of_race(const Document& document, bool at_rest) {
  if (!at_rest) return document;
  Document start = in_rest_pose(document);
  for (Handle& handle : start.handles)
    if (const Handle* wanted = find_handle(document, handle.id)) handle.target = wanted->target;
  return start;
}

}  // namespace foldless
