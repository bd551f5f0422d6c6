// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/run.h"

#include <string>
#include <utility>

#include "core/energy/constraints.h"
#include "core/error.h"
#include "core/method/methods.h"
#include "core/method/satisfied.h"

namespace foldless {
namespace {

OriginalMesh original_of(const Problem& problem) {
  return problem.original.value_or(OriginalMesh{
      std::make_shared<const Triangles>(problem.mesh.triangles()), problem.mesh.vertex_count()});
}

bool may_fold(std::string_view method) {
  const MethodRow* row = find_method(method);
  return row && row->may_fold;
}

}  // namespace

std::unique_ptr<Method> start_method(Problem problem) {
  const std::string& name = problem.parameters.method;
  if (const MethodRow* row = find_method(name)) return row->start(std::move(problem));
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
    : start_method_(starter),
      may_fold_(may_fold(problem.parameters.method)),
      energy_(problem.energy),
      parameters_(problem.parameters),
      handles_(problem.handles),
      original_(original_of(problem)),
      original_edges_(*original_.triangles, original_.vertices),
      diagonal_(active_diagonal(problem.mesh.triangles(), problem.mesh.rest(), problem.handles)) {
  const MeshPair& mesh = problem.mesh;
  const InjectivityChecker checker(mesh.triangles(), mesh.vertex_count());
  if (!checker.is_injective(mesh.rest()) || !checker.is_injective(mesh.deformed()))
    throw Error("the mesh to start from is folded; reset its pose");
  common_.generation = generation;
  common_.original_vertices = original_.vertices;
  Problem whole = problem;
  whole.original = original_;
  begin(std::move(whole));
}

// What is idle was proved with the whole and stays as it is: from here on the part is looked at.
void Run::begin(Problem whole) {
  part_ = ActivePart(whole.mesh, whole.handles);
  rest_before_ = whole.mesh.rest();
  deformed_before_ = whole.mesh.deformed();
  Problem part = part_.of(whole);
  const Points deformed = part.mesh.deformed();
  checker_ = InjectivityChecker(part.mesh.triangles(), part.mesh.vertex_count());
  if (part_.is_empty()) {
    adopt_connectivity(part.mesh);
    if (!snapshot_) publish(deformed, std::nullopt);
    return;
  }
  normalisation_ = normalisation_for(part.mesh.rest());
  normalise(part);
  adopt_connectivity(part.mesh);
  if (!snapshot_) publish(deformed, std::nullopt);
  method_ = start_method_(std::move(part));
}

void Run::normalise(Problem& part) {
  const MeshPair& mesh = part.mesh;
  const Points rest = normalisation_.to_unit_rest(mesh.rest());
  Points deformed = normalisation_.to_unit(mesh.deformed());
  if (!checker_.is_injective(deformed)) {
    // Subtracting the offset rounds; scaling alone does not.
    normalisation_.offset.setZero();
    deformed = normalisation_.to_unit(mesh.deformed());
  }
  if (!checker_.is_injective(rest) || !checker_.is_injective(deformed))
    throw Error("the mesh is too large or too small for double precision; scale it");
  for (Handle& handle : part.handles) handle.target = normalisation_.to_unit(handle.target);
  part.mesh.set_positions(rest, std::move(deformed));
}

std::optional<Outcome> Run::outcome() const {
  return method_ ? method_->outcome() : Outcome::gradient;
}

std::optional<Iteration> Run::step(std::stop_token token) {
  if (!method_) return std::nullopt;
  std::optional<Iteration> iteration = method_->step(std::move(token));
  if (!iteration) return std::nullopt;
  iteration = in_input_units(*iteration, normalisation_);
  const MeshPair& mesh = method_->mesh();
  if (mesh.revision() != common_.revision) adopt_connectivity(mesh);
  if (is_rest_injective_) publish(normalisation_.from_unit(mesh.deformed()), iteration);
  return iteration;
}

void Run::adopt_connectivity(const MeshPair& part) {
  const Points rest = normalisation_.from_unit_rest(part.rest());
  checker_ = InjectivityChecker(part.triangles(), part.vertex_count());
  is_rest_injective_ = checker_.is_injective(rest);
  common_.revision = part.revision();
  common_.triangles = std::make_shared<const Triangles>(
      part_.whole_triangles(part.triangles(), part.vertex_count()));
  common_.rest = std::make_shared<const Points>(part_.whole_points(rest, rest_before_));
  common_.flipped_edges =
      std::make_shared<const std::vector<Edge>>(original_edges_.flipped_in(*common_.triangles));
}

void Run::publish(Points part, const std::optional<Iteration>& iteration) {
  const InjectivityReport report = checker_.check(part);
  if (!report.is_injective() && !(may_fold_ && part.allFinite())) return;
  auto next = std::make_shared<Snapshot>(common_);
  next->folded_triangles = report.inverted + report.degenerate;
  next->branch_vertices = report.branch_vertices;
  next->deformed = part_.whole_points(part, deformed_before_);
  next->handles = handles_;
  next->iteration = iteration;
  snapshot_ = std::move(next);
  if (snapshot_->is_valid()) valid_ = snapshot_;
}

bool Run::is_satisfied() const {
  if (!snapshot_->is_valid()) return false;
  const double error = handle_error_squared(constraints_of(handles_), snapshot_->deformed);
  return error <= kSatisfied * diagonal_ * diagonal_;
}

void Run::set_targets(const Points& targets) {
  for (std::size_t i = 0; i < handles_.size(); ++i)
    handles_[i].target = targets.col(static_cast<Eigen::Index>(i));
  if (snapshot_->is_valid()) {
    if (method_) method_->set_targets(normalisation_.to_unit(targets));
    snapshot_ = with_new_targets(*snapshot_);
    valid_ = snapshot_;
    return;
  }
  snapshot_ = valid_ = with_new_targets(*valid_);
  begin(resumed());
}

std::shared_ptr<const Snapshot> Run::with_new_targets(const Snapshot& snapshot) const {
  auto next = std::make_shared<Snapshot>(snapshot);
  next->handles = handles_;
  return next;
}

Problem Run::resumed() const {
  return {MeshPair(*valid_->triangles, *valid_->rest, valid_->deformed), energy_, handles_,
          parameters_, original_};
}

}  // namespace foldless
