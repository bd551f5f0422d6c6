// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/check_line.h"

#include <utility>

namespace foldless {

std::string CheckLine::text() && {
  const bool is_ok = problems_.empty();
  object_.emplace_back("problems", JsonNode{std::move(problems_)});
  add("ok", is_ok);
  // Line breaks inside strings are escaped: those that are left, with the blanks that follow,
  // are layout.
  std::string line;
  bool is_layout = false;
  for (const char c : json_text({std::move(object_)})) {
    is_layout = c == '\n' || (is_layout && c == ' ');
    if (!is_layout) line += c;
  }
  return line + '\n';
}

}  // namespace foldless
