// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/conformal_system.h"

#include <algorithm>
#include <array>

#include "core/energy/shared_elements.h"
#include "core/error.h"
#include "core/large_pages.h"
#include "core/mesh/components.h"
#include "core/mesh/quality.h"
#include "core/method/satisfied.h"

namespace foldless {

/// As A (z |f_z − t|² + zbar |f_z̄|²) with t = 1, or the frame.
struct QuadraticEnergy {
  std::string_view density;
  double z, zbar;
  bool follows_frame;
};

namespace {

constexpr std::array kQuadraticEnergies{
    QuadraticEnergy{"dirichlet", 1, 1, false},
    QuadraticEnergy{"lscm", 0, 2, false},
    QuadraticEnergy{"arap", 1, 1, true},
};

const QuadraticEnergy* find_quadratic(const Density& density) {
  const auto row = std::ranges::find(kQuadraticEnergies, density.name, &QuadraticEnergy::density);
  return row == kQuadraticEnergies.end() ? nullptr : &*row;
}

constexpr std::size_t kElementsBetweenLooks = 8192;  ///< at the token

constexpr int kLocalGlobalSteps = 200;  ///< of arap, to its minimum without constraints

/// B of a rest triangle: f_z = Σ ½(g_x − i g_y) w_j and f_z̄ = Σ ½(g_x + i g_y) w_j over corners
/// w_j = x_j + i y_j with hat gradients (g_x, g_y).
Eigen::Matrix<double, 4, 6> derivative_matrix(const Eigen::Matrix<double, 2, 3>& gradients) {
  Eigen::Matrix<double, 4, 6> B;
  for (int j = 0; j < 3; ++j) {
    const double gx = 0.5 * gradients(0, j), gy = 0.5 * gradients(1, j);
    B.block<4, 2>(0, 2 * j) << gx, gy,  //
        -gy, gx,                        //
        gx, -gy,                        //
        gy, gx;
  }
  return B;
}

/// Every component of a problem under a conformal energy needs two handles, or it may grow.
void expect_two_handles(const Problem& problem, std::string_view method) {
  const std::vector<int> component =
      components_of(problem.mesh.triangles(), problem.mesh.vertex_count());
  std::vector<int> handles(component.size(), 0);
  const auto of = [&](const Handle& h) {
    return static_cast<std::size_t>(component[static_cast<std::size_t>(h.vertex)]);
  };
  for (const Handle& handle : problem.handles) ++handles[of(handle)];
  for (const Handle& handle : problem.handles)
    if (handles[of(handle)] == 1)
      throw Error("with the energy lscm, method '" + std::string(method) +
                  "' needs two handles on every part of the mesh; the part of vertex " +
                  std::to_string(handle.vertex) + " has one");
}

}  // namespace

ConformalSystem::ConformalSystem(const Problem& problem, std::string_view method)
    : solver(0, {}),
      density_(problem.energy),
      quadratic_(find_quadratic(*density_)),
      rest_(problem.mesh.rest()),
      diagonal_(bounding_box_diagonal(rest_)) {
  if (!quadratic_)
    throw Error("method '" + std::string(method) + "' has no energy '" +
                std::string(density_->name) + "'; choose dirichlet, lscm or arap");
  if (quadratic_->z == 0) expect_two_handles(problem, method);
  find_unknowns(problem);
  add_springs(problem);
  solver = ConeSolver(static_cast<int>(vertex_of_node_.size()), element_nodes());
}

void ConformalSystem::find_unknowns(const Problem& problem) {
  for (const Handle& handle : problem.handles)
    hard_vertices_.push_back(handle.kind == HandleKind::soft ? -1 : handle.vertex);
  std::vector<int> node_of_vertex(static_cast<std::size_t>(problem.mesh.vertex_count()), 0);
  for (const int v : hard_vertices_)
    if (v >= 0) node_of_vertex[static_cast<std::size_t>(v)] = -1;
  for (int v = 0; v < problem.mesh.vertex_count(); ++v) {
    int& node = node_of_vertex[static_cast<std::size_t>(v)];
    if (node < 0) continue;
    node = static_cast<int>(vertex_of_node_.size());
    vertex_of_node_.push_back(v);
  }
  for (const auto& t : problem.mesh.triangles().colwise()) {
    FreeTriangle triangle{t, {}, signed_area(rest_, t), {}};
    for (int j = 0; j < 3; ++j)
      triangle.nodes[static_cast<std::size_t>(j)] = node_of_vertex[static_cast<std::size_t>(t[j])];
    if (std::ranges::all_of(triangle.nodes, [](int node) { return node < 0; })) {
      held_.push_back(t);
      continue;
    }
    triangle.B = derivative_matrix(diagonal_ * hat_gradients(rest_.col(t[0]), rest_.col(t[1]),
                                                             rest_.col(t[2]), triangle.area));
    free_.push_back(triangle);
  }
}

void ConformalSystem::add_springs(const Problem& problem) {
  std::vector<int> handle_of_vertex(static_cast<std::size_t>(problem.mesh.vertex_count()), -1);
  for (std::size_t i = 0; i < problem.handles.size(); ++i)
    if (problem.handles[i].kind == HandleKind::soft)
      handle_of_vertex[static_cast<std::size_t>(problem.handles[i].vertex)] = static_cast<int>(i);
  for (std::size_t t = 0; t < free_.size(); ++t)
    for (int corner = 0; corner < 3; ++corner) {
      int& handle = handle_of_vertex[static_cast<std::size_t>(free_[t].vertices[corner])];
      if (handle < 0) continue;
      springs_.push_back(
          {t, corner, handle,
           problem.parameters.alpha * problem.handles[static_cast<std::size_t>(handle)].weight});
      handle = -1;  // one triangle of the vertex has its spring
    }
}

std::vector<std::array<int, 3>> ConformalSystem::element_nodes() const {
  std::vector<std::array<int, 3>> nodes;
  for (const FreeTriangle& triangle : free_) nodes.push_back(triangle.nodes);
  return nodes;
}

std::vector<ConformalParts> ConformalSystem::parts(const Points& u) const {
  std::vector<ConformalParts> parts(free_.size());
  for_triangles(triangle_count(), [&](std::ptrdiff_t i) {
    const auto t = static_cast<std::size_t>(i);
    parts[t] = conformal_parts(deformation_gradient(rest_, u, free_[t].vertices));
  });
  return parts;
}

TriangleTerm ConformalSystem::energy_term(const Complex& frame) const {
  return {.z_weight = quadratic_->z,
          .zbar_weight = quadratic_->zbar,
          .z_target = quadratic_->follows_frame ? frame : Complex(1)};
}

Points ConformalSystem::with_handles(Points u, const Points& targets) const {
  for (std::size_t i = 0; i < hard_vertices_.size(); ++i)
    if (hard_vertices_[i] >= 0)
      u.col(hard_vertices_[i]) = targets.col(static_cast<Eigen::Index>(i));
  return u;
}

// In blocks: the elements of a million triangles are half a gigabyte, whose clearing alone takes
// longer than a stop may.
bool ConformalSystem::make_program(const ProgramParts& parts, const std::stop_token& token,
                                   ConeProgram& program) const {
  if (program.empty()) reserve_large_pages(program, free_.size());
  for (std::size_t begin = 0; begin < free_.size(); begin += kElementsBetweenLooks) {
    if (token.stop_requested()) return false;
    const std::size_t end = std::min(begin + kElementsBetweenLooks, free_.size());
    if (program.size() < end) program.resize(end);
    for_triangles(static_cast<std::ptrdiff_t>(end - begin), [&](std::ptrdiff_t i) {
      const std::size_t t = begin + static_cast<std::size_t>(i);
      program[t] = element(parts.u, free_[t], parts.term_of(t));
    });
  }
  for (const Spring& spring : springs_) {
    ConeElement& e = program[spring.triangle];
    e.P.diagonal().segment<2>(2 * spring.corner).array() += 2 * spring.stiffness;
    e.q.segment<2>(2 * spring.corner) -=
        2 * spring.stiffness * parts.targets.col(spring.handle) / diagonal_;
  }
  return true;
}

ConeSolution ConformalSystem::solve(const ProgramParts& parts, double tolerance,
                                    const std::stop_token& token) {
  if (!make_program(parts, token, program_)) return {};
  return solver.solve(program_, tolerance, token);
}

ConeElement ConformalSystem::element(const Points& u, const FreeTriangle& triangle,
                                     const TriangleTerm& term) const {
  ConeElement e;
  const Eigen::Vector4d target(term.z_target.real(), term.z_target.imag(), term.zbar_target.real(),
                               term.zbar_target.imag());
  const Eigen::Vector4d weights(term.z_weight, term.z_weight, term.zbar_weight, term.zbar_weight);
  const double area = triangle.area / (diagonal_ * diagonal_);
  const Eigen::Matrix<double, 6, 4> BD = 2 * area * triangle.B.transpose() * weights.asDiagonal();
  e.nodes = triangle.nodes;
  e.weight = area;
  e.P = BD * triangle.B;
  e.q = -BD * target;
  e.G = term.R * triangle.B;
  for (int j = 0; j < 3; ++j) {
    if (triangle.nodes[static_cast<std::size_t>(j)] >= 0) continue;
    const Vec2 held = u.col(triangle.vertices[j]) / diagonal_;
    e.q += e.P.middleCols<2>(2 * j) * held;
    e.g += e.G.middleCols<2>(2 * j) * held;
  }
  return e;
}

Points ConformalSystem::moved(Points u, const Eigen::VectorXd& x) const {
  for (std::size_t node = 0; node < vertex_of_node_.size(); ++node)
    u.col(vertex_of_node_[node]) = diagonal_ * x.segment<2>(2 * static_cast<Eigen::Index>(node));
  return u;
}

std::optional<Points> ConformalSystem::unconstrained_minimum(const Points& u, const Points& targets,
                                                             const std::stop_token& token) {
  std::vector<Complex> frames(free_.size(), 1);
  const ProgramParts cost{u, targets, [&](std::size_t t) { return energy_term(frames[t]); }};
  if (!make_program(cost, token, program_)) return std::nullopt;
  solver.factorize_cost(program_, token);
  if (token.stop_requested()) return std::nullopt;
  Points minimum = moved(u, solver.minimize_cost(program_, token));
  for (int step = 1; quadratic_->follows_frame && step < kLocalGlobalSteps; ++step) {
    if (token.stop_requested()) return std::nullopt;
    const std::vector<ConformalParts> now = parts(minimum);
    for_triangles(triangle_count(), [&](std::ptrdiff_t i) {
      const auto t = static_cast<std::size_t>(i);
      frames[t] = direction_of(now[t].f_z, frames[t]);
    });
    if (!make_program(cost, token, program_)) return std::nullopt;
    minimum = moved(u, solver.minimize_cost(program_, token));
  }
  if (token.stop_requested()) return std::nullopt;
  return minimum;
}

bool ConformalSystem::are_held_triangles_bounded(const Points& u, double K) const {
  return std::ranges::all_of(held_, [&](const Eigen::Vector3i& t) {
    const Vec2 sigma = signed_singular_values(deformation_gradient(rest_, u, t));
    return sigma[1] > 0 && sigma[0] <= K * sigma[1];
  });
}

bool ConformalSystem::is_bounded(const Points& u, double K) const {
  return std::ranges::all_of(free_, [&](const FreeTriangle& triangle) {
    const Vec2 sigma = signed_singular_values(deformation_gradient(rest_, u, triangle.vertices));
    return sigma[1] > 0 && sigma[0] <= K * sigma[1];
  });
}

double ConformalSystem::energy(const Points& u) const {
  double sum = 0;
  for (const FreeTriangle& triangle : free_)
    sum += triangle.area * density_->value(deformation_gradient(rest_, u, triangle.vertices));
  for (const Eigen::Vector3i& t : held_)
    sum += signed_area(rest_, t) * density_->value(deformation_gradient(rest_, u, t));
  return sum;
}

Iteration record_of(const ConformalSystem& system, const MeshPair& mesh, const Points& previous,
                    const Constraints& constraints) {
  const Quality quality = quality_of(mesh.triangles(), mesh.rest(), mesh.deformed());
  Iteration iteration;
  iteration.distortion_energy = iteration.energy = system.energy(mesh.deformed());
  iteration.handle_error_squared = handle_error_squared(constraints, mesh.deformed());
  iteration.step_infinity_norm = (mesh.deformed() - previous).cwiseAbs().maxCoeff();
  iteration.min_area_ratio = quality.min_area_ratio;
  iteration.max_conformal_distortion = quality.max_conformal_distortion;
  iteration.mean_conformal_distortion = quality.mean_conformal_distortion;
  iteration.factorizations = system.solver.factorizations();
  return iteration;
}

}  // namespace foldless
