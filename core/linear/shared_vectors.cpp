// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/shared_vectors.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "core/threads/team.h"

namespace foldless {
namespace {

/// The value of every segment, in their order.
template <class Value>
std::vector<double> of_segments(Eigen::Index size, const Value& value) {
  std::vector<double> values(
      static_cast<std::size_t>((size + kEntriesTogether - 1) / kEntriesTogether));
  in_parallel(static_cast<int>(values.size()), [&](int i) {
    const std::ptrdiff_t begin = i * kEntriesTogether;
    values[static_cast<std::size_t>(i)] = value(begin, std::min(kEntriesTogether, size - begin));
  });
  return values;
}

}  // namespace

double shared_dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  const std::vector<double> sums =
      of_segments(a.size(), [&](Eigen::Index begin, Eigen::Index length) {
        return a.segment(begin, length).dot(b.segment(begin, length));
      });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

void add_multiple(double s, const Eigen::VectorXd& x, Eigen::VectorXd& y) {
  in_ranges(y.size(), kEntriesTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    y.segment(begin, end - begin) += s * x.segment(begin, end - begin);
  });
}

double largest_magnitude(const Eigen::VectorXd& a) {
  double largest = 0;
  for (const double own : of_segments(a.size(), [&](Eigen::Index begin, Eigen::Index length) {
         return a.segment(begin, length).lpNorm<Eigen::Infinity>();
       }))
    largest = std::max(largest, own);
  return largest;
}

}  // namespace foldless
