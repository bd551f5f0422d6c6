// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/multigrid.h"

#include <utility>

namespace foldless {

Eigen::VectorXd VCycle::operator()(const Eigen::VectorXd& r) {
  Eigen::VectorXd x = smoother_.smoothed(r), image(r.size());
  multiply(matrix_, x, image);
  coarser_.correct(r - image, x);
  multiply(matrix_, x, image);
  x += smoother_.smoothed(r - image);
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
