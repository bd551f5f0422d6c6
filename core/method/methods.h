// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/method/method.h"

namespace foldless {

/// One row of the table of methods.
struct MethodRow {
  std::string_view name;      ///< word in scene files and on the command line
  std::string_view title;     ///< words for the interface
  std::string_view citation;  ///< key of docs/bibliography.md
  std::unique_ptr<Method> (*start)(
      const Problem& problem);  ///< problem: rest diagonal about 1, see Run
  /// Meshes of the method may be folded or wind twice round a vertex, by its nature: they are
  /// published, marked as what they are.
  bool may_fold = false;
  /// Its meshes may overlap themselves at boundary vertices: likewise.
  bool may_overlap = false;
  std::span<const std::string_view> parameters = {};  ///< names of Parameters that it reads
  std::optional<double> beta =
      std::nullopt;  ///< its default β per unit rest area; else the energy's
};

/// Every method of the program; the authority for names.
std::span<const MethodRow> methods();
std::vector<std::string_view> method_names();

/// The row of that name, or null. The row lives as long as the program.
const MethodRow* find_method(std::string_view name);

/// True when the parameter of that name changes what the method does.
bool reads(const MethodRow& method, std::string_view parameter);
/// β of a method that the scene gives none. An unknown method has the energy's.
double default_beta(std::string_view method, const Density& energy);

}  // namespace foldless
