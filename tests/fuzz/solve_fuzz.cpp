// SPDX-License-Identifier: GPL-3.0-or-later
// Small meshes under every method, with targets that change and cancels on the way: every mesh that
// is published is as it says, to the judge. At the end it says how many they were.
#include <map>
#include <stop_token>

#include "core/energy/densities.h"
#include "core/mesh/generate.h"
#include "core/mesh/injective.h"
#include "core/method/methods.h"
#include "core/run/run.h"
#include "tests/fuzz/judged.h"

namespace foldless {
namespace {

using fuzz::Input;

Shape shape_of(Input& input) {
  const int n = 2 + input.below(6);
  switch (input.below(3)) {
    case 0:
      return grid({.columns = n,
                   .rows = 1 + input.below(6),
                   .width = 1,
                   .height = 0.7,
                   .diagonal = static_cast<Diagonal>(input.below(3))});
    case 1: return annulus({.inner_radius = 0.2, .outer_radius = 0.5, .sectors = 8 + n});
    default: return disk({.rings = 3, .boundary_vertices = 14, .vertices = 31, .radius = 0.5});
  }
}

Vec2 target_of(Input& input) {
  const double x = input.between(-1, 1);
  return {x, input.between(-1, 1)};
}

/// Handles on vertices that the input names, each once.
std::vector<Handle> handles_of(Input& input, const Points& rest) {
  std::vector<bool> is_held(static_cast<std::size_t>(rest.cols()));
  std::vector<Handle> handles;
  for (int i = 1 + input.below(5); i > 0; --i) {
    const int v = input.below(static_cast<int>(rest.cols()));
    if (is_held[static_cast<std::size_t>(v)]) continue;
    is_held[static_cast<std::size_t>(v)] = true;
    Handle handle;
    handle.id = static_cast<int>(handles.size());
    handle.vertex = v;
    handle.kind = static_cast<HandleKind>(input.below(3));
    handle.target = input.below(3) == 0 ? Vec2(rest.col(v)) : target_of(input);
    if (input.below(8) == 0) handle.turn = Turn{input.between(-400, 400), input.between(0.01, 0.5)};
    handles.push_back(handle);
  }
  return handles;
}

Problem problem_of(Input& input) {
  const Shape shape = shape_of(input);
  Problem problem;
  problem.mesh = MeshPair(shape.triangles, shape.rest);
  problem.energy =
      &densities()[static_cast<std::size_t>(input.below(static_cast<int>(densities().size())))];
  problem.parameters.method =
      methods()[static_cast<std::size_t>(input.below(static_cast<int>(methods().size())))].name;
  problem.handles = handles_of(input, shape.rest);
  problem.original = OriginalMesh{std::make_shared<const Triangles>(shape.triangles),
                                  static_cast<int>(shape.rest.cols())};
  return problem;
}

/// Of meshes that were judged, by method.
class Count : public std::map<std::string, long> {
 public:
  ~Count() {
    for (const auto& [method, meshes] : *this)
      std::cerr << method << ": " << meshes << " meshes judged\n";
  }
};

Count judged_meshes;

void judge_snapshot(const Snapshot& snapshot, const MethodRow& method) {
  fuzz::expect_judged_injective(*snapshot.triangles, *snapshot.rest);
  const bool is_clean = snapshot.is_valid() && snapshot.overlapping_boundary_vertices == 0;
  const bool is_injective =
      judge::objections_to(fuzz::judged(*snapshot.triangles, snapshot.deformed)).empty();
  fuzz::expect(is_clean == is_injective, "a snapshot says what it is");
  fuzz::expect(is_injective || method.may_fold || method.may_overlap, "the method keeps its word");
  ++judged_meshes[std::string(method.name)];
}

}  // namespace
}  // namespace foldless

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foldless;
  constexpr int kMostSteps = 60;
  Input input(data, size);
  fuzz::refuse_or_do([&] {
    const Problem problem = problem_of(input);
    const MethodRow& method = *find_method(problem.parameters.method);
    Run run(problem);
    judge_snapshot(*run.snapshot(), method);
    std::stop_source stop;
    for (int i = 0; i < kMostSteps; ++i) {
      const int command = input.below(16);
      if (command == 1) stop.request_stop();
      if (command == 2) stop = std::stop_source();
      if (command == 3) {
        Points targets(2, static_cast<Eigen::Index>(problem.handles.size()));
        for (auto target : targets.colwise()) target = target_of(input);
        run.set_targets(targets);
      }
      const auto before = run.snapshot();
      if (!run.step(stop.get_token()) && (run.outcome() || input.is_empty())) break;
      if (run.snapshot() != before) judge_snapshot(*run.snapshot(), method);
    }
  });
  return 0;
}
