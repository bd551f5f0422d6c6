// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/chebyshev.h"

#include <atomic>
#include <cstddef>

#include "core/threads/team.h"

namespace foldless {
namespace {

/// Nodes that a thread smooths together.
constexpr std::ptrdiff_t kSmoothedTogether = 1024;

// Chebyshev's polynomial on [0.6, 2.4], whose middle is 1.5 and half length 0.9.
constexpr double kMiddle = 1.5, kHalfLength = 0.9;
constexpr double kRatio = kMiddle / kHalfLength;
constexpr double kFirstRho = 1 / kRatio;
constexpr double kSecondRho = 1 / (2 * kRatio - kFirstRho);
constexpr double kFirst = 1 / kMiddle;
constexpr double kKept = kSecondRho * kFirstRho, kAdded = 2 * kSecondRho / kHalfLength;

}  // namespace

ChebyshevSmoother::ChebyshevSmoother(const SparseSymmetric& A)
    : matrix_(A), inverses_(static_cast<std::size_t>(A.nodes)) {
  std::atomic<bool> is_definite = true;
  each_in_ranges(A.nodes, kSmoothedTogether, [&](std::ptrdiff_t i) {
    const auto node = static_cast<std::size_t>(i);
    const double* first = &A.value[static_cast<std::size_t>(A.first_column(node))];
    const double a = first[0], b = first[1],
                 c = A.value[static_cast<std::size_t>(A.second_column(node))];
    const double determinant = a * c - b * b;
    if (!(a > 0 && determinant > 0)) is_definite.store(false, std::memory_order_relaxed);
    inverses_[node] = {c / determinant, -b / determinant, a / determinant};
  });
  is_definite_ = is_definite;
}

void ChebyshevSmoother::smooth(const Eigen::VectorXd& r, Eigen::VectorXd& x,
                               Eigen::VectorXd& image) const {
  x.resize(r.size());
  each_in_ranges(matrix_.nodes, kSmoothedTogether, [&](std::ptrdiff_t i) {
    x.segment<2>(2 * i) = kFirst * (inverses_[static_cast<std::size_t>(i)] * r.segment<2>(2 * i));
  });
  multiply(matrix_, x, image);
  each_in_ranges(matrix_.nodes, kSmoothedTogether, [&](std::ptrdiff_t i) {
    const Eigen::Vector2d left = r.segment<2>(2 * i) - image.segment<2>(2 * i);
    x.segment<2>(2 * i) = (1 + kKept) * x.segment<2>(2 * i) +
                          kAdded * (inverses_[static_cast<std::size_t>(i)] * left);
  });
}

}  // namespace foldless
