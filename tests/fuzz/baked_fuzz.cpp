// SPDX-License-Identifier: GPL-3.0-or-later
// Baked animations. What is read and written again reads as the same text, and is proved or not.
#include "core/scene/baked_io.h"
#include "tests/fuzz/judged.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foldless;
  fuzz::refuse_or_do([&] {
    const fuzz::MemoryFile file(fuzz::Input(data, size).rest());
    const BakedAnimation animation = read_baked(file.path());
    fuzz::expect_judged_injective(animation.triangles, animation.rest);
    const std::vector<BakedFailure> failures = failures_of(animation);
    const std::string text = baked_text(animation, failures);
    const fuzz::MemoryFile again(text);
    const BakedAnimation read = read_baked(again.path());
    fuzz::expect(baked_text(read, failures_of(read)) == text,
                 "an animation reads as it was written");
  });
  return 0;
}
