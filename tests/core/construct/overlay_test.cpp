// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/overlay.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include "tests/support/all_triangulations.h"
#include "tests/support/glued_polygon.h"

namespace foldless {
namespace {

/// A random triangulation of the corners i … k.
void add_pieces(std::mt19937_64& random, int i, int k, test::Pieces& pieces) {
  if (k - i < 2) return;
  const int j = i + 1 + static_cast<int>(random() % static_cast<unsigned>(k - i - 1));
  add_pieces(random, i, j, pieces);
  add_pieces(random, j, k, pieces);
  pieces.emplace_back(i, j, k);
}

Triangles random_triangulation(std::mt19937_64& random, int corners) {
  test::Pieces pieces;
  add_pieces(random, 0, corners - 1, pieces);
  return test::as_triangles(pieces);
}

/// Where two straight chords of a polygon cross.
Vec2 intersection(const Points& polygon, const Edge& f, const Edge& s) {
  const Vec2 a = polygon.col(f[0]), d = polygon.col(f[1]) - a;
  const Vec2 b = polygon.col(s[0]), e = polygon.col(s[1]) - b;
  return a + cross(b - a, e) / cross(d, e) * d;
}

TEST(Overlay, HasTheFacesAndTheOrdersOfStraightChordsInARegularPolygon) {
  int crossings = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    const int corners = 3 + static_cast<int>(seed % 20);
    const Triangles first = random_triangulation(random, corners);
    const Triangles second = random_triangulation(random, corners);
    const Overlay overlay = overlay_of(corners, first, second);
    const Points polygon = test::regular_polygon(corners);
    Points points(2, corners + static_cast<int>(overlay.crossings.size()));
    points.leftCols(corners) = polygon;
    std::map<Edge, std::map<double, double>> places;  // on a chord: t, and where it really is
    Eigen::Index next = corners;
    for (const ChordCrossing& crossing : overlay.crossings) {
      const Vec2 p = intersection(polygon, crossing.first.chord, crossing.second.chord);
      points.col(next++) = p;
      for (const auto& place : {crossing.first, crossing.second})
        places[place.chord][place.t] = (p - polygon.col(place.chord[0])).norm();
      ++crossings;
    }
    for (const auto& [chord, of_chord] : places) {
      double before = 0;
      for (const auto& [t, distance] : of_chord) {
        EXPECT_GT(distance, before);
        before = distance;
      }
    }
    double area = 0;
    for (const std::vector<int>& face : overlay.faces)
      for (std::size_t i = 0; i < face.size(); ++i) {
        const int a = face[i], b = face[(i + 1) % face.size()], c = face[(i + 2) % face.size()];
        EXPECT_GT(signed_area(points.col(a), points.col(b), points.col(c)), 0);
        area += 0.5 * cross(points.col(a), points.col(b));
      }
    EXPECT_NEAR(area, corners / 2.0 * std::sin(2 * 3.14159265358979323846 / corners), 1e-9);
    int crossings_of_chords = 0;
    for (const Edge& chord : chords_of(corners, first))
      crossings_of_chords += crossings_of(chord, chords_of(corners, second));
    EXPECT_EQ(crossings_of_chords, static_cast<int>(overlay.crossings.size()));
  }
  EXPECT_GT(crossings, 1000) << "the claim would be empty";
}

TEST(Overlay, OfATriangulationWithItselfIsThatTriangulation) {
  std::mt19937_64 random(1);
  const Triangles triangles = random_triangulation(random, 12);
  const Overlay overlay = overlay_of(12, triangles, triangles);
  EXPECT_TRUE(overlay.crossings.empty());
  std::set<std::set<int>> faces, pieces;
  for (const std::vector<int>& face : overlay.faces) faces.emplace(face.begin(), face.end());
  for (const auto& t : triangles.colwise()) pieces.insert({t[0], t[1], t[2]});
  EXPECT_EQ(faces, pieces);
}

}  // namespace
}  // namespace foldless
