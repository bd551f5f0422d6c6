// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/map_words.h"

namespace foldless {

std::string words_on(const InjectivityReport& report) {
  const int folded = report.inverted + report.degenerate;
  if (folded == 1) return "1 triangle folded";
  if (folded > 1) return std::to_string(folded) + " triangles folded";
  if (report.branch_vertices == 1) return "fold-free but 1 interior vertex winds twice";
  if (report.branch_vertices > 1)
    return "fold-free but " + std::to_string(report.branch_vertices) +
           " interior vertices wind twice";
  return {};
}

}  // namespace foldless
