// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <utility>

#include "app/cli/calls.h"
#include "app/cli/check_line.h"
#include "app/cli/command_line.h"
#include "core/scene/baked_io.h"
#include "core/scene/failure_words.h"

namespace foldless {

int check_animation(const std::filesystem::path& file) {
  const BakedAnimation animation = read_baked(file);
  const std::vector<BakedFailure> failures = failures_of(animation);
  const std::size_t count = animation.frames.size();
  const std::size_t steps = animation.loops ? count : count - 1;
  CheckLine line;
  line.add("vertices", static_cast<double>(animation.rest.cols()));
  line.add("faces", static_cast<double>(animation.triangles.cols()));
  line.add("frames", count + 0.0);
  line.add("steps", steps + 0.0);
  line.add("unproved_steps", failures.size() + 0.0);
  for (const BakedFailure& failure : failures) line.add_problem(words_of(failure, animation));
  std::cout << std::move(line).text();
  return failures.empty() ? kExitDone : kExitNotSatisfied;
}

}  // namespace foldless
