// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/multigrid.h"

#include <utility>

#include "core/linear/shared_vectors.h"

namespace foldless {

Eigen::VectorXd VCycle::operator()(const Eigen::VectorXd& r) {
  CoarseGrid::Room& room = coarser_.room_of_finer();
  const auto set_left_of = [&](const Eigen::VectorXd& x) {
    multiply(matrix_, x, room.image);
    subtract(r, room.image, room.left);
  };
  Eigen::VectorXd x;
  smoother_.smooth(r, x, room.image);
  set_left_of(x);
  coarser_.correct(room.left, x);
  set_left_of(x);
  smoother_.smooth(room.left, room.smoothed, room.image);
  add_multiple(1, room.smoothed, x);
  return x;
}

CoarseGrid::CoarseGrid(Interpolation to_finer, Cholesky factor)
    : to_finer_(std::move(to_finer)), factor_(std::move(factor)) {}

CoarseGrid::CoarseGrid(Interpolation to_finer, SparseSymmetric matrix,
                       std::shared_ptr<CoarseGrid> coarser)
    : to_finer_(std::move(to_finer)),
      matrix_(std::move(matrix)),
      coarser_(std::move(coarser)),
      cycle_(std::make_unique<VCycle>(matrix_, *coarser_)) {}

void CoarseGrid::correct(const Eigen::VectorXd& r, Eigen::VectorXd& x) {
  const Eigen::VectorXd restricted = to_finer_.restricted(r);
  to_finer_.add(cycle_ ? (*cycle_)(restricted) : factor_.precondition(restricted), x);
}

}  // namespace foldless
