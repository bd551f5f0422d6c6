// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>

#include "core/threads/team.h"
#include "core/threads/values_of_ranges.h"

namespace foldless {

/// Entries of a vector that a thread takes together: a microsecond or two.
constexpr std::ptrdiff_t kEntriesTogether = 4096;

/// aᵀb, summed by segments, so that it has the same bits however many threads share it.
double shared_dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b);

/// y = x.
void copy(const Eigen::VectorXd& x, Eigen::VectorXd& y);

/// difference = a − b.
void subtract(const Eigen::VectorXd& a, const Eigen::VectorXd& b, Eigen::VectorXd& difference);

/// y += s x.
void add_multiple(double s, const Eigen::VectorXd& x, Eigen::VectorXd& y);

/// a + s b, of any shape.
template <class Array>
Array sum_with_multiple(const Array& a, double s, const Array& b) {
  Array sum(a.rows(), a.cols());
  in_ranges(a.size(), kEntriesTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    sum.reshaped().segment(begin, end - begin) =
        a.reshaped().segment(begin, end - begin) + s * b.reshaped().segment(begin, end - begin);
  });
  return sum;
}

/// The largest magnitude of an entry; 0 where there is none.
double largest_magnitude(const Eigen::VectorXd& a);

/// That of a − b, of one shape.
template <class Array>
double largest_difference(const Array& a, const Array& b) {
  double largest = 0;
  for (const double own :
       values_of_ranges(a.size(), kEntriesTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
         return (a.reshaped().segment(begin, end - begin) -
                 b.reshaped().segment(begin, end - begin))
             .template lpNorm<Eigen::Infinity>();
       }))
    largest = std::max(largest, own);
  return largest;
}

}  // namespace foldless
