// SPDX-License-Identifier: GPL-3.0-or-later
// Deforms a square, beside OpenMP and a BLAS of its own, and fails where either is not as before.
#include <foldless/check.h>
#include <foldless/energy.h>
#include <foldless/session.h>
#include <foldless/version.h>
#include <omp.h>
#include <sys/stat.h>

#include <cfenv>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <string>
#include <vector>

extern "C" void dgemm_(const char*, const char*, const int*, const int*, const int*, const double*,
                       const double*, const int*, const double*, const int*, const double*, double*,
                       const int*);

namespace {

/// What a process has once and for all, and how OpenMP and the BLAS work.
std::string settings() {
  int threads = 0, total = 0;
#pragma omp parallel num_threads(3) reduction(+ : total)
  {
    total += 1 + omp_get_thread_num();
#pragma omp single
    threads = omp_get_num_threads();
  }
  const int n = 300;
  const double one = 1, zero = 0;
  const std::vector<double> a(n * n, 1.0);
  std::vector<double> c(n * n, 0.0);
  dgemm_("N", "N", &n, &n, &n, &one, a.data(), &n, a.data(), &n, &zero, c.data(), &n);
  sigset_t blocked;
  pthread_sigmask(SIG_BLOCK, nullptr, &blocked);
  const mode_t mask = umask(0);
  umask(mask);
  std::string words = std::to_string(threads) + " threads, sum " + std::to_string(total) +
                      ", at most " + std::to_string(omp_get_max_threads()) + ", product " +
                      std::to_string(c.back()) + ", umask " + std::to_string(mask) + ", locale " +
                      std::setlocale(LC_ALL, nullptr) + ", rounding " +
                      std::to_string(fegetround()) + ", blocked";
  for (int signal = 1; signal < 32; ++signal)
    if (sigismember(&blocked, signal) == 1) words += ' ' + std::to_string(signal);
  return words;
}

}  // namespace

int main() {
  const std::string before = settings();
  foldless::PointMatrix square(4, 2), targets(2, 2);
  foldless::TriangleMatrix triangles(2, 3);
  square << 0, 0, 1, 0, 1, 1, 0, 1;
  triangles << 0, 1, 2, 0, 2, 3;
  targets << 0, 0, 1.5, 1.2;
  const foldless::Result result = foldless::solve(square, triangles, {0, 2}, targets);
  const foldless::PointMatrix middle = result.map(foldless::PointMatrix::Constant(1, 2, 0.5));
  const bool is_valid =
      foldless::check(result.rest, result.triangles, result.deformed).is_injective();
  const std::string after = settings();
  std::printf("%s\n%s\n%s: middle at %g %g\n", before.c_str(), after.c_str(),
              foldless::library_version(), middle(0, 0), middle(0, 1));
  const bool is_as_before = before == after && before.starts_with("3 threads, sum 6, ") &&
                            before.find("product 300.0") != std::string::npos;
  return result.is_reached && is_valid && is_as_before ? 0 : 1;
}
