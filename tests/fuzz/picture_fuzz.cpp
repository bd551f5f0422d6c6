// SPDX-License-Identifier: GPL-3.0-or-later
// PNG, JPEG, WebP, GIF, OpenRaster, Krita and Photoshop files, their layers and their texts.
#include "render/image.h"
#include "render/layered/layered_image.h"
#include "tests/fuzz/input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foldless;
  const fuzz::MemoryFile file(fuzz::Input(data, size).rest());
  fuzz::refuse_or_do([&] {
    const Image image = load_image(file.path());
    fuzz::expect(image.width > 0 && image.height > 0, "a picture has pixels");
  });
  fuzz::refuse_or_do([&] { load_layered(file.path()); });
  fuzz::refuse_or_do([&] { read_png_texts(file.path()); });
  return 0;
}
