// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace foldless {

/// Entries of a vector that a thread takes together: a microsecond or two.
constexpr std::ptrdiff_t kEntriesTogether = 4096;

/// aᵀb, summed by segments, so that it has the same bits however many threads share it.
double shared_dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b);

/// y += s x.
void add_multiple(double s, const Eigen::VectorXd& x, Eigen::VectorXd& y);

/// The largest magnitude of an entry; 0 where there is none.
double largest_magnitude(const Eigen::VectorXd& a);

}  // namespace foldless
