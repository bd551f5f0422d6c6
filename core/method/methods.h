// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "core/method/method.h"

namespace foldless {

/// One row of the table of methods.
struct MethodRow {
  std::string_view name;      ///< word in scene files and on the command line
  std::string_view title;     ///< words for the interface
  std::string_view citation;  ///< key of the README's bibliography
  std::unique_ptr<Method> (*start)(Problem problem);  ///< problem: rest diagonal about 1, see Run
  /// Meshes of the method may be folded or wind twice round a vertex, by its nature: they are
  /// published, marked as what they are.
  bool may_fold = false;
};

/// Every method of the program; the authority for names.
std::span<const MethodRow> methods();

/// The row of that name, or null. The row lives as long as the program.
const MethodRow* find_method(std::string_view name);

}  // namespace foldless
