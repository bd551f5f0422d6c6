// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "core/energy/density.h"
#include "core/scene/parameters.h"

namespace foldless {

/// How a parameter is shown and changed.
enum class ParameterScale {
  linear,
  logarithmic,
  whole,   ///< integers
  on_off,  ///< 0 or 1
  choice   ///< the index of one of several words
};

/// One row of the solver panel.
struct ParameterRow {
  std::string_view name;     ///< as in scene files
  std::string_view title;    ///< words and the paper's letter
  std::string_view tooltip;  ///< one or two sentences
  double minimum = 0;
  double maximum = 1;
  ParameterScale scale = ParameterScale::linear;
  double (*get)(const Parameters&, const Density&);
  void (*set)(Parameters&, double);
  void (*reset)(Parameters&);
  std::span<const std::string_view> choices = {};  ///< words for the interface, of a choice
};

/// Every number of Parameters, in the order of the panel.
std::span<const ParameterRow> parameter_rows();
/// The row of that name, or null.
const ParameterRow* find_parameter_row(std::string_view name);

/// The value that reset gives; β depends on the method.
double default_of(const ParameterRow& row, Parameters parameters, const Density& energy);
/// True when the value differs from the default: the panel draws a dot.
bool is_changed(const ParameterRow& row, const Parameters& parameters, const Density& energy);

}  // namespace foldless
