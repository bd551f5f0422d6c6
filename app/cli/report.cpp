// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/report.h"

#include <string_view>
#include <utility>

#include "app/bench/parameters_node.h"
#include "core/energy/constraints.h"
#include "core/mesh/injective.h"
#include "core/mesh/quality.h"
#include "core/scene/handle_kind.h"
#include "core/scene/json_object.h"

namespace foldless {
namespace {

JsonNode energy_node(std::string_view name, const std::optional<Iteration>& state) {
  const auto value = [&](double Iteration::*member) {
    return state ? node_of((*state).*member) : JsonNode{nullptr};
  };
  return {object_of(JsonMember("name", node_of(name)),
                    JsonMember("distortion", value(&Iteration::distortion_energy)),
                    JsonMember("barrier", value(&Iteration::barrier_energy)),
                    JsonMember("penalty", value(&Iteration::penalty_energy)),
                    JsonMember("total", value(&Iteration::energy)))};
}

JsonNode seconds_node(const Solved& solved) {
  const StageTimes& times = solved.times;
  return {object_of(
      JsonMember("total", node_of(solved.seconds)), JsonMember("assemble", node_of(times.assemble)),
      JsonMember("analyze", node_of(times.analyze)),
      JsonMember("factorize", node_of(times.factorize)), JsonMember("solve", node_of(times.solve)),
      JsonMember("line_search", node_of(times.line_search)),
      JsonMember("flip", node_of(times.flip)), JsonMember("split", node_of(times.split)),
      JsonMember("wall", node_of(solved.wall_seconds)))};
}

int inverted_triangles(const Snapshot& snapshot) {
  const InjectivityChecker checker(*snapshot.triangles, static_cast<int>(snapshot.rest->cols()));
  int inverted = 0;
  for (const Points* points : {snapshot.rest.get(), &snapshot.deformed}) {
    const InjectivityReport report = checker.check(*points);
    inverted += report.inverted + report.degenerate;
  }
  return inverted;
}

JsonNode edges_node(const std::vector<Edge>& edges) {
  JsonNode::Array array;
  for (const Edge& edge : edges)
    array.push_back(
        {array_of(JsonNode{static_cast<double>(edge[0])}, JsonNode{static_cast<double>(edge[1])})});
  return {std::move(array)};
}

}  // namespace

JsonNode handles_node(const std::vector<Handle>& handles) {
  JsonNode::Array array;
  for (const Handle& handle : handles) {
    JsonNode::Object object = object_of(
        JsonMember("vertex", node_of(handle.vertex)),
        JsonMember("target", {array_of(node_of(handle.target.x()), node_of(handle.target.y()))}));
    if (handle.kind != HandleKind::drag)
      object.emplace_back("kind", node_of(handle_kind_name(handle.kind)));
    if (handle.kind == HandleKind::soft) object.emplace_back("weight", node_of(handle.weight));
    if (handle.depth != 0) object.emplace_back("depth", node_of(handle.depth));
    if (handle.turn) object.emplace_back("angle", node_of(handle.turn->angle));
    if (handle.turn) object.emplace_back("radius", node_of(handle.turn->radius));
    if (!handle.name.empty()) object.emplace_back("name", node_of(handle.name));
    array.push_back({std::move(object)});
  }
  return {std::move(array)};
}

JsonNode report_of(const Solved& solved) {
  const Snapshot& state = *solved.snapshot;
  const Iteration last = solved.iterations.empty() ? Iteration{} : solved.iterations.back();
  const Quality quality = quality_of(*state.triangles, *state.rest, state.deformed);
  JsonNode::Object report = object_of(
      JsonMember("scene", node_of(solved.scene)),
      JsonMember("method", node_of(solved.problem.parameters.method)),
      JsonMember("parameters", parameters_node(solved.problem.parameters, *solved.problem.energy)),
      JsonMember("vertices", node_of(static_cast<double>(state.rest->cols()))),
      JsonMember("faces", node_of(static_cast<double>(state.triangles->cols()))),
      JsonMember("original_vertices", node_of(state.original_vertices)),
      JsonMember("original_faces", node_of(solved.original_faces)),
      JsonMember("outcome", node_of(name_of(solved.outcome))),
      JsonMember("satisfied", {solved.satisfied}),
      JsonMember("handle_error_squared",
                 node_of(handle_error_squared(constraints_of(state.handles), state.deformed))),
      JsonMember("factorizations", node_of(last.factorizations)),
      JsonMember("updates", node_of(last.updates)),
      JsonMember("iterations", node_of(static_cast<double>(solved.iterations.size()))),
      JsonMember("outer_iterations", node_of(solved.iterations.empty() ? 0 : last.outer + 1)),
      JsonMember("flips", node_of(last.flips)), JsonMember("splits", node_of(last.splits)),
      JsonMember("energy", energy_node(solved.problem.energy->name, state.iteration)),
      JsonMember("gradient_norm_squared", state.iteration
                                              ? node_of(state.iteration->gradient_norm_squared)
                                              : JsonNode{nullptr}),
      JsonMember("conformal_distortion",
                 {object_of(JsonMember("max", node_of(quality.max_conformal_distortion)),
                            JsonMember("mean", node_of(quality.mean_conformal_distortion)))}),
      JsonMember("min_area_ratio", node_of(quality.min_area_ratio)),
      JsonMember("inverted", node_of(inverted_triangles(state))),
      JsonMember("folded", node_of(state.folded_triangles)),
      JsonMember("branch_vertices", node_of(state.branch_vertices)),
      JsonMember("overlapping_boundary_vertices", node_of(state.overlapping_boundary_vertices)),
      JsonMember("seconds", seconds_node(solved)),
      JsonMember("handles", handles_node(state.handles)),
      JsonMember("flipped_edges", edges_node(*state.flipped_edges)));
  if (!solved.verdict.empty()) report.emplace_back("verdict", node_of(solved.verdict));
  return {std::move(report)};
}

}  // namespace foldless
