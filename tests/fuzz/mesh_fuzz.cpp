// SPDX-License-Identifier: GPL-3.0-or-later
// OBJ, OFF and PLY: the first byte says which. What is read is locally injective, to a judge too,
// and an OBJ has texture coordinates for as many vertices.
#include <cstdlib>

#include "core/files/mesh_readers.h"
#include "core/files/validate.h"
#include "tests/fuzz/input.h"
#include "tests/fuzz/judged.h"

namespace foldless {
namespace {

PolygonSoup read(std::size_t kind, std::string_view text) {
  switch (kind) {
    case 0: return read_obj(text, "mesh");
    case 1: return read_off(text, "mesh");
    default: return read_ply(text, "mesh");
  }
}

}  // namespace
}  // namespace foldless

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foldless;
  fuzz::refuse_or_do([&] {
    fuzz::Input input(data, size);
    const auto kind = input.below(3);
    const auto text = input.rest();
    const TriangleSoup mesh = validated(planar_triangles(read(kind, text)));
    fuzz::expect_judged_injective(mesh.triangles, mesh.points);
    if (kind == 0 && read_obj_texture(text, "mesh").cols() != mesh.points.cols()) std::abort();
  });
  return 0;
}
