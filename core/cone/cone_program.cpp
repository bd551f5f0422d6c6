// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cone/cone_program.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/cone/second_order_cone.h"
#include "core/threads/team.h"

namespace foldless {
namespace {

constexpr int kMostIterations = 100;
constexpr double kStep = 0.99;  ///< of the way to the boundary of the cones
constexpr double kSmallestStep = 1e-10;
constexpr double kStartDepth = 0.1;   ///< of s in its cone
constexpr double kGapFactor = 10;     ///< tolerance of the gap, over that of the residuals
constexpr double kAcceptable = 1e-5;  ///< merit of a solution that rounding keeps from being better
constexpr int kPatience = 25;         ///< iterations without a tenth of gain
constexpr double kGain = 0.9;
constexpr double kFarkas = 1e-7;       ///< ‖Gᵀz‖_∞ / |gᵀz| of a certificate
constexpr double kFarkasFloor = 1e-3;  ///< smallest |gᵀz| that is not rounding

MiddleMatrices no_constraints(const ConeProgram& program) {
  return MiddleMatrices(program.size(), Eigen::Matrix3d::Zero());
}

using Cones = Eigen::Matrix3Xd;  ///< one vector a column, one column an element

constexpr std::ptrdiff_t kElementsTogether = 512;  ///< that a thread takes

/// Calls visit(t) for every column of `cones`, by the team of this thread.
template <class Visit>
void for_elements(const Cones& cones, const Visit& visit) {
  each_in_ranges(cones.cols(), kElementsTogether, visit);
}

/// One solve: the iterate (x, s, z), with s → Gx + g and z the multipliers of s ∈ Q.
class InteriorPoint {
 public:
  InteriorPoint(const ConeProgram& program, ConeMatrix& matrix)
      : program_(program), matrix_(matrix), scaling_(program.size()), middle_(program.size()) {}

  ConeSolution solve(double tolerance, const std::stop_token& token);

 private:
  /// How far the iterate is from being optimal.
  struct Residuals {
    Eigen::VectorXd dual;  ///< Px + q − Gᵀz
    Cones primal;          ///< Gx + g − s
    double gap = 0;        ///< sᵀz
    double objective = 0;
    double merit = 0;  ///< the largest of all, each in units of its tolerance
  };
  /// The best iterate so far, and how long ago there was a gain.
  struct Best {
    ConeSolution solution;
    double merit = std::numeric_limits<double>::infinity();
    double merit_of_last_gain = std::numeric_limits<double>::infinity();
    int iterations_without_gain = 0;
  };
  /// A change of (x, s, z).
  struct Direction {
    Eigen::VectorXd x;
    Cones s, z;
  };

  bool start();
  void measure();
  bool is_certificate() const;
  bool scale();
  bool advance();
  /// Not whole where it was stopped.
  Direction direction(const Cones& complementarity);
  double step_length(const Direction& d) const;
  Cones rows(const Eigen::VectorXd& x) const;
  Eigen::VectorXd transposed_rows(const Cones& z) const;
  double gap_after(const Direction& d, double t) const;
  Cones corrected(const Direction& affine) const;
  void remember_if_better();

  const ConeProgram& program_;
  ConeMatrix& matrix_;
  Eigen::VectorXd x_;
  Cones s_, z_;
  Residuals residuals_;
  std::vector<NesterovTodd> scaling_;
  MiddleMatrices middle_;  ///< W⁻²
  Best best_;
};

ConeSolution InteriorPoint::solve(double tolerance, const std::stop_token& token) {
  bool can_go_on = start();
  int iteration = 0;
  for (; can_go_on && iteration < kMostIterations; ++iteration) {
    if (token.stop_requested()) return {};
    measure();
    if (!std::isfinite(residuals_.merit)) break;
    remember_if_better();
    if (residuals_.merit < tolerance) break;
    if (is_certificate())
      return {ConeStatus::infeasible, x_, z_, residuals_.objective, iteration + 1};
    can_go_on = best_.iterations_without_gain < kPatience && scale() && advance();
  }
  if (token.stop_requested()) return {};
  best_.solution.status = best_.merit < std::max(tolerance, kAcceptable)
                              ? ConeStatus::solved
                              : ConeStatus::not_converged;
  best_.solution.iterations = iteration + 1;
  return std::move(best_.solution);
}

// x minimises the cost plus Σ A‖Gx + g‖².
bool InteriorPoint::start() {
  Eigen::VectorXd right = Eigen::VectorXd::Zero(matrix_.size());
  for (std::size_t t = 0; t < program_.size(); ++t) {
    const ConeElement& e = program_[t];
    middle_[t] = e.weight * Eigen::Matrix3d::Identity();
    add_corners(-e.q - e.weight * e.G.transpose() * e.g, e, right);
  }
  if (!matrix_.factorize(program_, middle_)) return false;
  x_ = matrix_.solve(program_, middle_, right);
  s_ = rows(x_);
  z_.setZero(3, s_.cols());
  for (Eigen::Index t = 0; t < s_.cols(); ++t) {
    const ConeElement& e = program_[static_cast<std::size_t>(t)];
    s_.col(t) += e.g;
    s_(0, t) += std::max(0.0, kStartDepth - depth(s_.col(t)));
    z_(0, t) = 2 * e.weight;
  }
  return true;
}

Cones InteriorPoint::rows(const Eigen::VectorXd& x) const {
  Cones rows(3, static_cast<Eigen::Index>(program_.size()));
  for_elements(rows, [&](Eigen::Index t) {
    const ConeElement& e = program_[static_cast<std::size_t>(t)];
    rows.col(t) = e.G * corners_of(x, e);
  });
  return rows;
}

Eigen::VectorXd InteriorPoint::transposed_rows(const Cones& z) const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(matrix_.size());
  for (std::size_t t = 0; t < program_.size(); ++t)
    add_corners(program_[t].G.transpose() * z.col(static_cast<Eigen::Index>(t)), program_[t], sum);
  return sum;
}

void InteriorPoint::measure() {
  Residuals& r = residuals_;
  r.dual = -transposed_rows(z_);
  r.primal = rows(x_) - s_;
  r.objective = 0;
  Eigen::VectorXd q = Eigen::VectorXd::Zero(x_.size());
  for (std::size_t t = 0; t < program_.size(); ++t) {
    const ConeElement& e = program_[t];
    const CornerVector corners = corners_of(x_, e);
    const CornerVector Pc = e.P * corners;
    r.objective += corners.dot(0.5 * Pc + e.q);
    r.primal.col(static_cast<Eigen::Index>(t)) += e.g;
    add_corners(e.q, e, q);
    add_corners(Pc, e, r.dual);
  }
  r.dual += q;
  r.gap = s_.cwiseProduct(z_).sum();
  r.merit = std::max({r.primal.norm(), r.dual.norm() / (1 + q.norm()),
                      r.gap / (kGapFactor * (1 + std::abs(r.objective)))});
}

// Farkas: were Gx + g in the cones for some x, then 0 ≤ zᵀ(Gx + g) = zᵀg < 0.
bool InteriorPoint::is_certificate() const {
  double gz = 0;
  for (std::size_t t = 0; t < program_.size(); ++t)
    gz += program_[t].g.dot(z_.col(static_cast<Eigen::Index>(t)));
  if (!(gz < -kFarkasFloor)) return false;
  return transposed_rows(z_).cwiseAbs().maxCoeff() <= kFarkas * -gz;
}

void InteriorPoint::remember_if_better() {
  ++best_.iterations_without_gain;
  if (residuals_.merit < kGain * best_.merit_of_last_gain) {
    best_.merit_of_last_gain = residuals_.merit;
    best_.iterations_without_gain = 0;
  }
  if (!(residuals_.merit < best_.merit)) return;
  best_.merit = residuals_.merit;
  best_.solution.x = x_;
  best_.solution.z = z_;
  best_.solution.objective = residuals_.objective;
}

bool InteriorPoint::scale() {
  for_elements(s_, [&](Eigen::Index t) {
    NesterovTodd& w = scaling_[static_cast<std::size_t>(t)];
    w = NesterovTodd(s_.col(t), z_.col(t));
    middle_[static_cast<std::size_t>(t)] = w.W_inv2;
  });
  return matrix_.factorize(program_, middle_);
}

// The predictor tells how much of the gap can go in one step, which chooses the centring σ of the
// corrector.
bool InteriorPoint::advance() {
  Cones complementarity(3, s_.cols());
  for (Eigen::Index t = 0; t < s_.cols(); ++t)
    complementarity.col(t) = -scaling_[static_cast<std::size_t>(t)].lambda;
  const Direction affine = direction(complementarity);
  if (matrix_.is_stopped()) return false;
  const Direction d = direction(corrected(affine));
  if (matrix_.is_stopped()) return false;
  const double t = std::min(1.0, kStep * step_length(d));
  if (!(t >= kSmallestStep)) return false;
  x_ += t * d.x;
  s_ += t * d.s;
  z_ += t * d.z;
  return true;
}

Cones InteriorPoint::corrected(const Direction& affine) const {
  const double t_affine = std::min(1.0, step_length(affine));
  const double sigma = std::pow(std::max(0.0, gap_after(affine, t_affine) / residuals_.gap), 3);
  const double mu = residuals_.gap / static_cast<double>(s_.cols());
  Cones complementarity(3, s_.cols());
  for_elements(s_, [&](Eigen::Index t) {
    const NesterovTodd& w = scaling_[static_cast<std::size_t>(t)];
    const Cone3 right = sigma * mu * Cone3::UnitX() -
                        cone_product(w.W_inv * affine.s.col(t), w.W * affine.z.col(t));
    complementarity.col(t) = cone_quotient(w.lambda, right) - w.lambda;
  });
  return complementarity;
}

double InteriorPoint::gap_after(const Direction& d, double t) const {
  return (s_ + t * d.s).cwiseProduct(z_ + t * d.z).sum();
}

// Newton's method on Px + q = Gᵀz, Gx + g = s and λ ∘ (W dz + W⁻¹ ds) = λ ∘ c, with ds and dz
// eliminated.
InteriorPoint::Direction InteriorPoint::direction(const Cones& complementarity) {
  const Residuals& r = residuals_;
  Cones scaled(3, s_.cols());
  for_elements(s_, [&](Eigen::Index t) {
    const NesterovTodd& w = scaling_[static_cast<std::size_t>(t)];
    scaled.col(t) = w.W_inv * complementarity.col(t) - w.W_inv2 * r.primal.col(t);
  });
  Direction d;
  d.x = matrix_.solve(program_, middle_, transposed_rows(scaled) - r.dual);
  if (matrix_.is_stopped()) return d;
  d.s = rows(d.x) + r.primal;
  d.z.resize(3, s_.cols());
  for_elements(s_, [&](Eigen::Index t) {
    const NesterovTodd& w = scaling_[static_cast<std::size_t>(t)];
    d.z.col(t) = w.W_inv * complementarity.col(t) - w.W_inv2 * d.s.col(t);
  });
  return d;
}

double InteriorPoint::step_length(const Direction& d) const {
  double t = std::numeric_limits<double>::infinity();
  for (Eigen::Index k = 0; k < s_.cols(); ++k)
    t = std::min({t, largest_step(s_.col(k), d.s.col(k)), largest_step(z_.col(k), d.z.col(k))});
  return t;
}

}  // namespace

ConeSolution ConeSolver::solve(const ConeProgram& program, double tolerance,
                               const std::stop_token& token) {
  matrix_.obey(token);
  ConeSolution solution = InteriorPoint(program, matrix_).solve(tolerance, token);
  matrix_.obey({});
  return solution;
}

bool ConeSolver::factorize_cost(const ConeProgram& program, const std::stop_token& token) {
  matrix_.obey(token);
  const bool has_factor = matrix_.factorize(program, no_constraints(program));
  matrix_.obey({});
  return has_factor;
}

Eigen::VectorXd ConeSolver::minimize_cost(const ConeProgram& program,
                                          const std::stop_token& token) {
  matrix_.obey(token);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(matrix_.size());
  for (const ConeElement& e : program) add_corners(-e.q, e, right);
  Eigen::VectorXd x = matrix_.solve(program, no_constraints(program), right);
  matrix_.obey({});
  return x;
}

}  // namespace foldless
