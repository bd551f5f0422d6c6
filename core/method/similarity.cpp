// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/similarity.h"

#include <cmath>

namespace foldless {
Vec2 Similarity::operator()(const Vec2& z) const {
  const std::complex<double> p = a * (complex(z) - from) + to;
  return {p.real(), p.imag()};
}

// a = Σ conj(z − z₀)(p − p₀) / Σ|z − z₀|² with the centres z₀ of the starts z and p₀ of the targets
// p.
Similarity similarity_of(const Points& starts, const Points& targets) {
  if (starts.cols() == 0) return {};
  Similarity s{.from = complex(starts.rowwise().mean()), .to = complex(targets.rowwise().mean())};
  std::complex<double> product = 0;
  double spread = 0;
  for (Eigen::Index i = 0; i < starts.cols(); ++i) {
    const std::complex<double> z = complex(starts.col(i)) - s.from;
    product += std::conj(z) * (complex(targets.col(i)) - s.to);
    spread += std::norm(z);
  }
  if (std::abs(product) > 1e-12 * spread) s.a = product / spread;
  return s;
}

double left_of_way(const Similarity& similarity, const Points& starts, const Points& targets) {
  double sum = 0;
  for (Eigen::Index i = 0; i < starts.cols(); ++i)
    sum += (targets.col(i) - similarity(starts.col(i))).squaredNorm();
  return std::sqrt(sum);
}

}  // namespace foldless
