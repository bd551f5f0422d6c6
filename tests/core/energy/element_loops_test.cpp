// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/element_loops.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "core/energy/densities.h"

namespace foldless {
namespace {

constexpr int kTriangles = 200;

/// Triangles of their own, some of them hardly deformed, some nearly crushed.
struct Soup {
  Triangles triangles{3, kTriangles};
  Points rest_points{2, 3 * kTriangles}, u{2, 3 * kTriangles};
  std::vector<RestElement> rest;
  int below_rest_area = 0;

  explicit Soup(unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto corners = [&](double least_area) {
      Corners c;
      do {
        for (double& x : c.reshaped()) x = unit(random);
      } while (signed_area(c.col(0), c.col(1), c.col(2)) < least_area);
      return c;
    };
    for (int t = 0; t < kTriangles; ++t) {
      triangles.col(t) = Eigen::Vector3i(3 * t, 3 * t + 1, 3 * t + 2);
      const Corners at_rest = corners(0.1);
      rest_points.middleCols<3>(3 * t) = at_rest;
      u.middleCols<3>(3 * t) = t % 4 == 0 ? Corners(at_rest * (1 + 0.01 * unit(random)))
                                          : corners(t % 4 == 1 ? 1e-3 : 0.05);
      rest.push_back(rest_element(at_rest));
      rest.back().stiffness = 1.5 + unit(random);
      below_rest_area += signed_area(u, triangles.col(t)) < rest.back().area;
    }
  }
};

std::vector<EnergySettings> all_settings() {
  std::vector<EnergySettings> all;
  for (const Density& density : densities())
    for (const Reference reference : {Reference::rest, Reference::equilateral})
      for (const bool flag : {false, true})
        all.push_back({.density = &density,
                       .beta = 0.3,
                       .delta = 1e-4,
                       .area_weighted = flag,
                       .unit_area = 1.7,
                       .barrier_area_weighted = !flag,
                       .reference = reference,
                       .conformal_weight = flag ? 0.2 : 0,
                       .conformal_power = reference == Reference::rest ? 2 : 16});
  return all;
}

std::vector<ElementLoops> all_loops(DensityKind kind) {
  std::vector<ElementLoops> all{plain_element_loops(kind)};
  for (const ElementLoops* loops : {avx2_element_loops(kind), avx512_element_loops(kind)})
    if (loops) all.push_back(*loops);
  return all;
}

void expect_same(const ElementEnergy& a, const ElementEnergy& b) {
  EXPECT_EQ(a.distortion, b.distortion);
  EXPECT_EQ(a.barrier, b.barrier);
}

/// What the loops give for triangles begin ≤ t < end against what each gives alone.
void expect_bits_of_each(const ElementLoops& loops, const ElementBatch& batch, int begin, int end) {
  const auto count = static_cast<std::size_t>(end - begin);
  std::vector<ElementEnergy> values(count), energies(count), energies_of_hessians(count);
  std::vector<Matrix2<double>> gradients(count), gradients_of_hessians(count);
  std::vector<BlocksOf<double>> hessians(count);
  loops.energies(batch, begin, end, {values.data(), nullptr, nullptr});
  loops.gradients(batch, begin, end, {energies.data(), gradients.data(), nullptr});
  loops.hessians(batch, begin, end,
                 {energies_of_hessians.data(), gradients_of_hessians.data(), hessians.data()});
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t t = static_cast<std::size_t>(begin) + i;
    SCOPED_TRACE(testing::Message() << "triangle " << t << " of " << begin << " to " << end);
    const RestElement rest = reference_element(batch.settings, batch.rest[t]);
    const Corners corners = corners_of(batch.u, batch.triangles.col(static_cast<Eigen::Index>(t)));
    const ElementHessian one = element_hessian(batch.settings, rest, corners, batch.clamping);
    const ElementGradient first = element_gradient(batch.settings, rest, corners);
    expect_same(values[i], element_energy(batch.settings, rest, corners));
    expect_same(energies[i], first.energy);
    expect_same(energies_of_hessians[i], one.energy);
    for (int corner = 0; corner < 3; ++corner) {
      EXPECT_EQ(gradient_of_corner(gradients[i], corner), first.gradient.segment<2>(2 * corner));
      EXPECT_EQ(gradient_of_corner(gradients_of_hessians[i], corner),
                one.gradient.segment<2>(2 * corner));
      EXPECT_EQ(columns_of_corner(hessians[i], corner), one.hessian.middleCols<2>(2 * corner));
    }
  }
}

TEST(ElementLoops, GiveTheBitsOfEachTriangleAlone) {
  const Soup soup(5);
  ASSERT_GT(soup.below_rest_area, kTriangles / 4) << "the barrier would not be seen";
  ASSERT_LT(soup.below_rest_area, 3 * kTriangles / 4);
  for (const EnergySettings& settings : all_settings())
    for (const ElementLoops& loops : all_loops(settings.density->kind))
      for (const double clamping : {0.0, 0.5, 1.0}) {
        SCOPED_TRACE(testing::Message()
                     << loops.name << ", " << settings.density->name << ", clamping " << clamping);
        const ElementBatch batch{settings, soup.triangles, soup.rest, soup.u, clamping};
        expect_bits_of_each(loops, batch, 0, kTriangles);
        if (testing::Test::HasFailure()) return;
      }
}

TEST(ElementLoops, EndWhereTheTrianglesDo) {
  const Soup soup(6);
  const EnergySettings settings{.density = find_density("arap")};
  const ElementBatch batch{settings, soup.triangles, soup.rest, soup.u, 1};
  for (const ElementLoops& loops : all_loops(settings.density->kind))
    for (int begin = 0; begin < 5; ++begin)
      for (int count = 0; count < 10; ++count)
        expect_bits_of_each(loops, batch, begin, begin + count);
}

TEST(ElementLoops, SayInfiniteOfTrianglesBeyondTheBoundAndOfNoOther) {
  Soup soup(7);
  const EnergySettings settings{.density = find_density("symmetric-dirichlet"), .beta = 0};
  for (const int t : {1, 6, 199}) soup.u.col(3 * t) = soup.u.col(3 * t + 1);
  const ElementBatch batch{settings, soup.triangles, soup.rest, soup.u, 0};
  for (const ElementLoops& loops : all_loops(settings.density->kind)) {
    std::vector<ElementEnergy> energies(kTriangles);
    loops.energies(batch, 0, kTriangles, {energies.data(), nullptr, nullptr});
    for (int t = 0; t < kTriangles; ++t)
      EXPECT_EQ(std::isinf(energies[static_cast<std::size_t>(t)].total()),
                t == 1 || t == 6 || t == 199)
          << t;
  }
}

}  // namespace
}  // namespace foldless
