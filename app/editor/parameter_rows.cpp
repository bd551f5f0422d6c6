// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/parameter_rows.h"

#include <algorithm>
#include <array>

#include "core/method/methods.h"

namespace foldless {
namespace {

/// Reads, writes and resets one member of Parameters.
template <auto Member>
struct Access {
  using Value = std::remove_cvref_t<decltype(Parameters{}.*Member)>;
  static double get(const Parameters& p, const Density&) { return static_cast<double>(p.*Member); }
  static void set(Parameters& p, double value) {
    if constexpr (std::is_enum_v<Value>)
      p.*Member = static_cast<Value>(static_cast<int>(value));
    else
      p.*Member = static_cast<Value>(value);
  }
  static void reset(Parameters& p) { p.*Member = Parameters{}.*Member; }
};

double beta_of(const Parameters& p, const Density& energy) {
  return p.beta.value_or(default_beta(p.method, energy));
}

template <auto Member>
constexpr ParameterRow row(std::string_view name, std::string_view title,
                           std::string_view tooltip) {
  using A = Access<Member>;
  return {name, title, tooltip, 0, 1, ParameterScale::on_off, A::get, A::set, A::reset};
}

constexpr ParameterRow ranged(ParameterRow row, double minimum, double maximum,
                              ParameterScale scale) {
  row.minimum = minimum;
  row.maximum = maximum;
  row.scale = scale;
  return row;
}

/// Titles of StartFrames, in its order.
constexpr std::array<std::string_view, 3> kStartTitles{"Rest", "Unconstrained", "Continuation"};

constexpr ParameterRow chosen(ParameterRow row, std::span<const std::string_view> choices) {
  row.maximum = static_cast<double>(choices.size() - 1);
  row.scale = ParameterScale::choice;
  row.choices = choices;
  return row;
}

constexpr auto kLogarithmic = ParameterScale::logarithmic;
constexpr auto kWhole = ParameterScale::whole;

constexpr std::array kRows{
    ranged(row<&Parameters::alpha>("alpha", "Handle weight \u03b1",
                                   "How strongly handles are pulled to their targets. Larger is "
                                   "stricter and harder to solve."),
           1, 1e12, kLogarithmic),
    ParameterRow{"beta", "Barrier weight \u03b2",
                 "How strongly triangles resist being squashed. Larger keeps them away from "
                 "collapse; the default depends on the method and the energy.",
                 1e-8, 1e4, kLogarithmic, beta_of, [](Parameters& p, double v) { p.beta = v; },
                 [](Parameters& p) { p.beta.reset(); }},
    ranged(row<&Parameters::delta>("delta", "Smallest area ratio \u03b4",
                                   "No triangle may shrink to this fraction of its area at rest."),
           1e-12, 0.5, kLogarithmic),
    ranged(row<&Parameters::eta>("eta", "Flip threshold \u03b7",
                                 "An edge is flipped when that lowers the energy of its two "
                                 "triangles by more than this fraction."),
           1e-9, 1, kLogarithmic),
    ranged(row<&Parameters::inner_iterations>("inner_iterations", "Inner iterations",
                                              "Most vertex updates in one round, N_in."),
           1, 100000, kWhole),
    ranged(row<&Parameters::outer_iterations>("outer_iterations", "Outer rounds",
                                              "Most rounds of relaxing and updating, N_out."),
           1, 1000, kWhole),
    ranged(row<&Parameters::gradient_tolerance>("gradient_tolerance", "Gradient tolerance",
                                                "Solved when the squared length of the gradient "
                                                "is below this."),
           1e-16, 1, kLogarithmic),
    ranged(row<&Parameters::step_tolerance>("step_tolerance", "Step tolerance",
                                            "At rest when no vertex moves by this fraction of the "
                                            "mesh's diagonal."),
           1e-16, 1e-2, kLogarithmic),
    row<&Parameters::condition_test>("condition_test", "Condition test",
                                     "Take a flip back when it makes the two triangles harder to "
                                     "solve."),
    row<&Parameters::area_weighted>("area_weighted", "Weight by area",
                                    "Large triangles count for more. Off: every triangle counts "
                                    "the same, Green strain only."),
    chosen(row<&Parameters::start>("start", "Start frames",
                                   "Bounded conformal distortion only: the rotations that its "
                                   "first program is about. Continuation moves the handles in "
                                   "steps; it is not in [Lip12] and goes much farther."),
           kStartTitles),
    ranged(row<&Parameters::distortion_bound>("distortion_bound", "Distortion bound K",
                                              "Largest stretch ratio that bounded conformal "
                                              "distortion and injective projection allow."),
           1.01, 1e6, kLogarithmic),
};

}  // namespace

std::span<const ParameterRow> parameter_rows() { return kRows; }

const ParameterRow* find_parameter_row(std::string_view name) {
  const auto it = std::find_if(kRows.begin(), kRows.end(),
                               [name](const ParameterRow& r) { return r.name == name; });
  return it == kRows.end() ? nullptr : &*it;
}

double default_of(const ParameterRow& row, Parameters parameters, const Density& energy) {
  row.reset(parameters);
  return row.get(parameters, energy);
}

bool is_changed(const ParameterRow& row, const Parameters& parameters, const Density& energy) {
  return row.get(parameters, energy) != default_of(row, parameters, energy);
}

}  // namespace foldless
