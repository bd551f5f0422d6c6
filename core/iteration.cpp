// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/iteration.h"

namespace foldless {

std::string_view name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::gradient: return "gradient";
    case Outcome::step: return "step";
    case Outcome::iteration_limit: return "iteration-limit";
    case Outcome::infeasible: return "infeasible";
    case Outcome::not_converged: return "not-converged";
    case Outcome::cancelled: return "cancelled";
    case Outcome::time_limit: return "time-limit";
  }
  return "";
}

std::string_view name_of(Phase phase) {
  switch (phase) {
    case Phase::update: return "update";
    case Phase::relax: return "relax";
    case Phase::approach: return "approach";
    case Phase::transport: return "transport";
    case Phase::pursue: return "pursue";
    case Phase::construct: return "construct";
    case Phase::settle: return "settle";
    case Phase::coarse: return "coarse";
    case Phase::whitened: return "whitened";
    case Phase::anew: return "anew";
    case Phase::walk: return "walk";
  }
  return "";
}

}  // namespace foldless
