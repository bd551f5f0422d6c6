// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/run.h"

#include <string>
#include <utility>

#include "core/energy/constraints.h"
#include "core/error.h"
#include "core/method/methods.h"

namespace foldless {
namespace {

OriginalMesh original_of(const Problem& problem) {
  return problem.original.value_or(OriginalMesh{
      std::make_shared<const Triangles>(problem.mesh.triangles()), problem.mesh.vertex_count()});
}

Licence licence_of(std::string_view method) {
  const MethodRow* row = find_method(method);
  if (!row) return {};
  return {.to_fold = row->may_fold, .to_overlap = row->may_overlap};
}

}  // namespace

std::unique_ptr<Method> start_method(const Problem& problem) {
  const std::string& name = problem.parameters.method;
  if (const MethodRow* row = find_method(name)) return row->start(problem);
  std::string known;
  for (const MethodRow& row : methods())
    known += (known.empty() ? "" : ", ") + std::string(row.name);
  throw Error("there is no method '" + name + "'; choose one of: " + known);
}

Iteration in_input_units(Iteration iteration, const Normalisation& normalisation) {
  const double length = 1 / normalisation.scale;
  const double area = length * length;
  iteration.distortion_energy *= area;
  iteration.penalty_energy *= area;
  iteration.barrier_energy *= area;
  iteration.energy *= area;
  // E is s² times what it is in input units, and u is s times: ∇E is s times.
  iteration.gradient_norm_squared *= area;
  iteration.handle_error_squared *= area;
  iteration.step_infinity_norm *= length;
  return iteration;
}

Run::Run(const Problem& problem, std::uint64_t generation, const MethodStarter& starter)
    : Run(problem, generation, starter, ActivePart(problem.mesh, problem.handles)) {}

Run::Run(const Problem& problem, std::uint64_t generation, const MethodStarter& starter,
         ActivePart part)
    : start_method_(starter),
      energy_(problem.energy),
      parameters_(problem.parameters),
      stiffness_(problem.mesh.stiffness()),
      original_(original_of(problem)),
      goal_(problem.handles, *original_.triangles, problem.mesh.rest(), part.diagonal()) {
  Problem begun = with_followers(problem);
  begun.original = original_;
  publisher_.emplace(begun, std::move(part), generation);
  snapshot_ = valid_ = with_handles(*publisher_->first());
  if (!publisher_->is_idle()) method_ = start_method_(publisher_->part_of(begun));
}

std::optional<Outcome> Run::outcome() const {
  return method_ ? method_->outcome() : Outcome::gradient;
}

std::optional<Iteration> Run::step(const std::stop_token& token) {
  if (!method_) return std::nullopt;
  std::optional<Iteration> iteration = method_->step(token);
  if (!iteration) return std::nullopt;
  iteration = in_input_units(*iteration, normalisation());
  if (auto next = publisher_->publish(method_->mesh(), licence_of(parameters_.method))) {
    next->handles = goal_.handles();
    next->iteration = iteration;
    snapshot_ = std::move(next);
    if (snapshot_->is_valid()) valid_ = snapshot_;
  }
  return iteration;
}

bool Run::is_satisfied() const {
  return snapshot_->is_valid() && goal_.is_met(snapshot_->deformed);
}

void Run::set_targets(const Points& targets, const std::vector<double>& angles) {
  goal_.set_targets(targets, angles);
  const bool goes_on = snapshot_->is_valid();
  snapshot_ = valid_ = with_handles(*valid_);
  if (!method_) return;
  if (goes_on) {
    const Points all = constraints_of(goal_.with_followers()).targets;
    method_->set_targets(normalisation().to_unit(all));
    return;
  }
  const Problem problem = with_followers(resumed());
  publisher_.emplace(problem, ActivePart(problem.mesh, problem.handles), valid_->generation);
  method_ = start_method_(publisher_->part_of(problem));
}

Problem Run::with_followers(Problem problem) const {
  problem.handles = goal_.with_followers();
  return problem;
}

std::shared_ptr<const Snapshot> Run::with_handles(const Snapshot& snapshot) const {
  auto next = std::make_shared<Snapshot>(snapshot);
  next->handles = goal_.handles();
  return next;
}

Problem Run::resumed() const {
  MeshPair mesh(*valid_->triangles, *valid_->rest, valid_->deformed);
  mesh.set_stiffness(stiffness_);
  return {std::move(mesh), energy_, goal_.handles(), parameters_, original_};
}

}  // namespace foldless
