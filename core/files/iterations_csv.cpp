// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/iterations_csv.h"

#include <array>
#include <string_view>

#include "core/files/text_lines.h"

namespace foldless {
namespace {

/// A column of iterations.csv: its name and its field.
struct Column {
  std::string_view name;
  void (*append)(std::string& text, const Iteration& record);
};

template <auto Member>
void append(std::string& text, const Iteration& record) {
  append_number(text, record.*Member);
}

void append_phase(std::string& text, const Iteration& record) { text += name_of(record.phase); }

constexpr std::array kColumns{
    Column{"outer", append<&Iteration::outer>},
    Column{"inner", append<&Iteration::inner>},
    Column{"phase", append_phase},
    Column{"E_d", append<&Iteration::distortion_energy>},
    Column{"E_c", append<&Iteration::penalty_energy>},
    Column{"E_b", append<&Iteration::barrier_energy>},
    Column{"E", append<&Iteration::energy>},
    Column{"gradient_norm_squared", append<&Iteration::gradient_norm_squared>},
    Column{"handle_error_squared", append<&Iteration::handle_error_squared>},
    Column{"step_infinity_norm", append<&Iteration::step_infinity_norm>},
    Column{"mu", append<&Iteration::mu>},
    Column{"step_length", append<&Iteration::step_length>},
    Column{"flips", append<&Iteration::flips>},
    Column{"splits", append<&Iteration::splits>},
    Column{"min_area_ratio", append<&Iteration::min_area_ratio>},
    Column{"seconds", append<&Iteration::seconds>},
    Column{"factorizations", append<&Iteration::factorizations>},
    Column{"updates", append<&Iteration::updates>},
    Column{"conformal_distortion_max", append<&Iteration::max_conformal_distortion>},
    Column{"conformal_distortion_mean", append<&Iteration::mean_conformal_distortion>},
};

}  // namespace

std::string iteration_columns() {
  std::string text;
  for (const Column& column : kColumns) {
    if (!text.empty()) text += ',';
    text += column.name;
  }
  return text;
}

void append_iteration(std::string& text, const Iteration& record) {
  for (const Column& column : kColumns) {
    if (&column != &kColumns.front()) text += ',';
    column.append(text, record);
  }
}

std::string iterations_csv(const std::vector<Iteration>& iterations) {
  std::string text = iteration_columns() + '\n';
  for (const Iteration& record : iterations) {
    append_iteration(text, record);
    text += '\n';
  }
  return text;
}

}  // namespace foldless
