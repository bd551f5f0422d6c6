// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/iteration.h"

namespace foldless {

std::string_view name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::gradient: return "gradient";
    case Outcome::step: return "step";
    case Outcome::iteration_limit: return "iteration-limit";
    case Outcome::cancelled: return "cancelled";
  }
  return "";
}

std::string_view name_of(Phase phase) { return phase == Phase::update ? "update" : "relax"; }

}  // namespace foldless
