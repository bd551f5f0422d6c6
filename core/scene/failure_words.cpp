// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/failure_words.h"

#include <cmath>

#include "core/files/text_lines.h"

namespace foldless {

std::string words_of(const BakedFailure& failure, const BakedAnimation& animation) {
  const std::size_t next = failure.from + 1;
  const double from = animation.frames[failure.from].frame;
  const double to =
      next < animation.frames.size() ? animation.frames[next].frame : animation.cycle_frames;
  std::string words;
  using Place = MotionFailure::Place;
  const std::string index = std::to_string(failure.failure.index);
  if (failure.failure.place == Place::triangle) words = "triangle " + index + " has no area";
  if (failure.failure.place == Place::boundary_vertex)
    words = "the mesh closes round boundary vertex " + index;
  if (failure.failure.place == Place::branch_vertex)
    words = "vertex " + index + " is covered more than once";
  words += " at frame ";
  append_number(words, std::round(1e4 * (from + failure.failure.moment * (to - from))) / 1e4);
  return words;
}

}  // namespace foldless
