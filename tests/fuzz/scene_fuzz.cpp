// SPDX-License-Identifier: GPL-3.0-or-later
// Scene files. What is read and written again reads as the same text.
#include "core/method/methods.h"
#include "core/scene/scene_io.h"
#include "tests/fuzz/judged.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foldless;
  fuzz::refuse_or_do([&] {
    const fuzz::MemoryFile file(fuzz::Input(data, size).rest());
    const Scene scene = load_scene(file.path(), method_names()).scene;
    fuzz::expect_judged_injective(scene.triangles, scene.rest);
    const std::string text = scene_text(scene, scene.folder);
    const fuzz::MemoryFile again(text);
    fuzz::expect(scene_text(load_scene(again.path(), method_names()).scene, scene.folder) == text,
                 "a scene reads as it was written");
  });
  return 0;
}
