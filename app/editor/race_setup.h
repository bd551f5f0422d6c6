// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/editor/document.h"
#include "app/editor/parameter_rows.h"

namespace foldless {

inline constexpr std::size_t kFewestLanes = 2;
inline constexpr std::size_t kMostLanes = 4;

/// Method, energy and every number of the solver, as a scene file has them.
struct RaceScene {
  std::filesystem::path file;
  Parameters parameters;
  const Density* energy = nullptr;

  bool operator==(const RaceScene&) const = default;
};

/// Reads what a lane can take from a scene file. Throws Error as load_scene() does.
RaceScene load_race_scene(const std::filesystem::path& file);

/// What the lanes of a race differ in, and where they start. Everything else is the document's.
struct RaceSetup {
  const ParameterRow* varied = nullptr;  ///< null: the method or the energy
  std::vector<std::string> methods;      ///< a lane each, names of methods(), when that is varied
  std::vector<const Density*> energies;  ///< a lane each, when the energy is varied
  std::vector<double> values;            ///< a lane each, when a parameter is varied
  /// Lanes that take everything but mesh and handles from a scene, whatever else is varied.
  std::map<std::size_t, RaceScene> scenes;
  bool starts_at_rest = true;  ///< false: from the mesh as it is

  bool varies_energy() const { return !energies.empty(); }
  /// Only one of the three has lanes.
  std::size_t lane_count() const { return methods.size() + energies.size() + values.size(); }
  bool operator==(const RaceSetup&) const = default;
};

/// The document's method and those that follow in methods(), at most four.
RaceSetup method_race(const Document& document);

/// The document's energy and those that follow in densities(), at most four.
RaceSetup energy_race(const Document& document);

/// Three values of a parameter: a logarithmic one in steps of ten, a switch on and off.
RaceSetup parameter_race(const ParameterRow& row, const Document& document);

/// One lane more, different from the others where possible, or the last one less. Within 2 … 4.
RaceSetup with_lane(RaceSetup setup);
RaceSetup without_lane(RaceSetup setup);

/// One lane as it is run.
struct RaceEntry {
  std::string title;        ///< no two of a race are alike
  std::string short_title;  ///< nor these, for where there is little room
  Parameters parameters;
  const Density* energy = nullptr;
};
std::vector<RaceEntry> entries_of(const RaceSetup& setup, const Document& document);

/// The document that a race starts from: its handles with their targets, and its mesh as it is or
/// at rest. Precondition: not empty.
Document start_of_race(const Document& document, bool at_rest);

}  // namespace foldless
