// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/report.h"

#include <string_view>
#include <utility>

#include "app/bench/parameters_node.h"
#include "core/energy/constraints.h"
#include "core/mesh/injective.h"
#include "core/mesh/quality.h"
#include "core/scene/handle_kind.h"

namespace foldless {
namespace {

JsonNode energy_node(std::string_view name, const std::optional<Iteration>& state) {
  const auto value = [&](double Iteration::*member) {
    return state ? node_of((*state).*member) : JsonNode{nullptr};
  };
  return {JsonNode::Object{{"name", node_of(name)},
                           {"distortion", value(&Iteration::distortion_energy)},
                           {"barrier", value(&Iteration::barrier_energy)},
                           {"penalty", value(&Iteration::penalty_energy)},
                           {"total", value(&Iteration::energy)}}};
}

JsonNode seconds_node(const Solved& solved) {
  const StageTimes& times = solved.times;
  return {JsonNode::Object{{"total", node_of(solved.seconds)},
                           {"assemble", node_of(times.assemble)},
                           {"analyze", node_of(times.analyze)},
                           {"factorize", node_of(times.factorize)},
                           {"solve", node_of(times.solve)},
                           {"line_search", node_of(times.line_search)},
                           {"flip", node_of(times.flip)},
                           {"split", node_of(times.split)},
                           {"wall", node_of(solved.wall_seconds)}}};
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
        {JsonNode::Array{{static_cast<double>(edge[0])}, {static_cast<double>(edge[1])}}});
  return {std::move(array)};
}

}  // namespace

JsonNode handles_node(const std::vector<Handle>& handles) {
  JsonNode::Array array;
  for (const Handle& handle : handles) {
    JsonNode::Object object{
        {"vertex", node_of(handle.vertex)},
        {"target", {JsonNode::Array{node_of(handle.target.x()), node_of(handle.target.y())}}}};
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
  JsonNode::Object report{
      {"scene", node_of(solved.scene)},
      {"method", node_of(solved.problem.parameters.method)},
      {"parameters", parameters_node(solved.problem.parameters, *solved.problem.energy)},
      {"vertices", node_of(static_cast<double>(state.rest->cols()))},
      {"faces", node_of(static_cast<double>(state.triangles->cols()))},
      {"original_vertices", node_of(state.original_vertices)},
      {"original_faces", node_of(solved.original_faces)},
      {"outcome", node_of(name_of(solved.outcome))},
      {"satisfied", {solved.satisfied}},
      {"handle_error_squared",
       node_of(handle_error_squared(constraints_of(state.handles), state.deformed))},
      {"factorizations", node_of(last.factorizations)},
      {"updates", node_of(last.updates)},
      {"iterations", node_of(static_cast<double>(solved.iterations.size()))},
      {"outer_iterations", node_of(solved.iterations.empty() ? 0 : last.outer + 1)},
      {"flips", node_of(last.flips)},
      {"splits", node_of(last.splits)},
      {"energy", energy_node(solved.problem.energy->name, state.iteration)},
      {"gradient_norm_squared",
       state.iteration ? node_of(state.iteration->gradient_norm_squared) : JsonNode{nullptr}},
      {"conformal_distortion",
       {JsonNode::Object{{"max", node_of(quality.max_conformal_distortion)},
                         {"mean", node_of(quality.mean_conformal_distortion)}}}},
      {"min_area_ratio", node_of(quality.min_area_ratio)},
      {"inverted", node_of(inverted_triangles(state))},
      {"folded", node_of(state.folded_triangles)},
      {"branch_vertices", node_of(state.branch_vertices)},
      {"overlapping_boundary_vertices", node_of(state.overlapping_boundary_vertices)},
      {"seconds", seconds_node(solved)},
      {"handles", handles_node(state.handles)},
      {"flipped_edges", edges_node(*state.flipped_edges)},
  };
  if (!solved.verdict.empty()) report.emplace_back("verdict", node_of(solved.verdict));
  return {std::move(report)};
}

}  // namespace foldless
