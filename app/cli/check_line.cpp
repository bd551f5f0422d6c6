// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/check_line.h"

#include <utility>

namespace foldless {

std::string CheckLine::text() && {
  const bool is_ok = problems_.empty();
  object_.emplace_back("problems", JsonNode{std::move(problems_)});
  add("ok", is_ok);
  return json_line({std::move(object_)}) + '\n';
}

}  // namespace foldless
