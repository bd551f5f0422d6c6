// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <string>

#include "app/cli/calls.h"
#include "app/cli/command_line.h"
#include "app/cli/failure_words.h"
#include "core/files/text_lines.h"
#include "core/scene/baked_io.h"

namespace foldless {

int check_animation(const std::filesystem::path& file) {
  const BakedAnimation animation = read_baked(file);
  const std::vector<BakedFailure> failures = failures_of(animation);
  const std::size_t count = animation.frames.size();
  const std::size_t steps = animation.loops ? count : count - 1;
  std::string line = "{\"vertices\": " + std::to_string(animation.rest.cols());
  line += ", \"faces\": " + std::to_string(animation.triangles.cols());
  line += ", \"frames\": " + std::to_string(count);
  line += ", \"steps\": " + std::to_string(steps);
  line += ", \"unproved_steps\": " + std::to_string(failures.size());
  line += ", \"problems\": [";
  for (std::size_t i = 0; i < failures.size(); ++i)
    line += (i == 0 ? "\"" : ", \"") + words_of(failures[i], animation) + "\"";
  line += std::string("], \"ok\": ") + (failures.empty() ? "true" : "false") + "}\n";
  std::cout << line;
  return failures.empty() ? kExitDone : kExitNotSatisfied;
}

}  // namespace foldless
