// SPDX-License-Identifier: GPL-3.0-or-later
// OBJ, OFF and PLY: the first byte says which. What is read is locally injective, to a judge too.
#include "core/files/mesh_readers.h"
#include "core/files/validate.h"
#include "tests/fuzz/input.h"
#include "tests/fuzz/judged.h"

namespace foldless {
namespace {

PolygonSoup read(fuzz::Input& input) {
  switch (input.below(3)) {
    case 0: return read_obj(input.rest(), "mesh");
    case 1: return read_off(input.rest(), "mesh");
    default: return read_ply(input.rest(), "mesh");
  }
}

}  // namespace
}  // namespace foldless

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foldless;
  fuzz::refuse_or_do([&] {
    fuzz::Input input(data, size);
    const TriangleSoup mesh = validated(planar_triangles(read(input)));
    fuzz::expect_judged_injective(mesh.triangles, mesh.points);
  });
  return 0;
}
