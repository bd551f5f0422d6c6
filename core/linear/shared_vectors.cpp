// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/shared_vectors.h"

#include <algorithm>
#include <numeric>

#include "core/threads/team.h"
#include "core/threads/values_of_ranges.h"

namespace foldless {

double shared_dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  const auto sums =
      values_of_ranges(a.size(), kEntriesTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
        return a.segment(begin, end - begin).dot(b.segment(begin, end - begin));
      });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

void copy(const Eigen::VectorXd& x, Eigen::VectorXd& y) {
  y.resize(x.size());
  in_ranges(x.size(), kEntriesTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    y.segment(begin, end - begin) = x.segment(begin, end - begin);
  });
}

void subtract(const Eigen::VectorXd& a, const Eigen::VectorXd& b, Eigen::VectorXd& difference) {
  difference.resize(a.size());
  in_ranges(a.size(), kEntriesTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    difference.segment(begin, end - begin) =
        a.segment(begin, end - begin) - b.segment(begin, end - begin);
  });
}

void add_multiple(double s, const Eigen::VectorXd& x, Eigen::VectorXd& y) {
  in_ranges(y.size(), kEntriesTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    y.segment(begin, end - begin) += s * x.segment(begin, end - begin);
  });
}

double largest_magnitude(const Eigen::VectorXd& a) {
  double largest = 0;
  for (const double own :
       values_of_ranges(a.size(), kEntriesTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
         return a.segment(begin, end - begin).lpNorm<Eigen::Infinity>();
       }))
    largest = std::max(largest, own);
  return largest;
}

}  // namespace foldless
