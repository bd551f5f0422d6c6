// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/vector_figure.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "app/export/placed_mesh.h"
#include "render/figure.h"
#include "render/image_difference.h"
#include "tests/support/errors.h"
#include "tests/support/pictures.h"
#include "tests/support/pixels.h"
#include "tests/support/rasterised.h"
#include "tests/support/ribbons.h"

namespace foldless {
namespace {

constexpr std::array kFormats{VectorFormat::svg, VectorFormat::pdf};

/// Nothing but `layers` of a small figure.
FigureOptions figure_of(std::initializer_list<bool Layers::*> layers) {
  FigureOptions options;
  options.width = 400;
  options.height = 300;
  options.style.layers = test::bare_view().layers;
  for (bool Layers::*const layer : layers) options.style.layers.*layer = true;
  return options;
}

FigureOptions with_image(FigureOptions options, Image image) {
  options.texture = whole_texture(std::move(image));
  return options;
}

Image of_one_colour(std::array<std::uint8_t, 4> colour) {
  Image image(40, 30);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = colour[i % 4];
  return image;
}

/// Bent, with a handle that is away from its target, a flipped edge and a split vertex.
Snapshot bent_sheet() {
  Snapshot snapshot = test::undeformed(test::square_grid(6));
  for (auto p : snapshot.deformed.colwise()) p += Vec2(0.3 * p.y() * p.y(), 0.2 * p.x());
  snapshot.handles.push_back({1, 14, {0, 6}, HandleKind::drag, 1});
  snapshot.handles.push_back({2, 0, {0, 0}, HandleKind::pin, 1});
  snapshot.handles.push_back({3, 35, {9, 6}, HandleKind::soft, 1});
  snapshot.flipped_edges = std::make_shared<const std::vector<Edge>>(std::vector<Edge>{{7, 8}});
  snapshot.original_vertices = 35;
  return snapshot;
}

std::size_t occurrences(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    ++count;
  return count;
}

/// Both formats, made pictures of by other programs, are like the picture of OpenGL: soft edges
/// differ, areas do not.
void expect_like_the_picture(const Snapshot& snapshot, const FigureOptions& options) {
  const Image picture = render_figure(snapshot, options);
  for (const VectorFormat format : kFormats) {
    const auto drawn = test::rasterised(format, vector_figure(format, snapshot, options));
    if (!drawn) GTEST_SKIP() << "librsvg2-bin or poppler-utils is missing";
    ASSERT_EQ(drawn->width, picture.width);
    ASSERT_EQ(drawn->height, picture.height);
    const ImageDifference difference = difference_of(picture, *drawn, 64);
    EXPECT_LT(difference.mean, 0.8) << "of PDF: " << (format == VectorFormat::pdf);
    EXPECT_LT(difference.pixels, 0.006 * picture.width * picture.height);
  }
}

TEST(VectorFigure, IsLikeThePictureWithEveryLayer) {
  FigureOptions options = figure_of({&Layers::fill, &Layers::wireframe, &Layers::boundary,
                                     &Layers::handles, &Layers::remeshed, &Layers::rest});
  options.view = FigureView::both;
  options.miniature = true;
  for (const Theme theme : {Theme::dark, Theme::light, Theme::contrast}) {
    options.style.theme = theme;
    expect_like_the_picture(bent_sheet(), options);
  }
}

TEST(VectorFigure, IsLikeThePictureWithAHeatMapAndItsLegend) {
  for (const HeatMeasure measure : {HeatMeasure::conformal, HeatMeasure::area}) {
    FigureOptions options = figure_of({&Layers::heat, &Layers::boundary});
    options.style.heat_measure = measure;
    expect_like_the_picture(bent_sheet(), options);
  }
}

TEST(VectorFigure, IsLikeThePictureWithAnImage) {
  const AlphaMap all{64, 48, std::vector<std::uint8_t>(std::size_t{64} * 48, 255)};
  expect_like_the_picture(bent_sheet(), with_image(figure_of({&Layers::fill}), test::painted(all)));
}

/// Two sheets that lie over each other at rest, the first in front; each shows its own layer, and
/// is larger than that.
TEST(VectorFigure, IsLikeThePictureWithTheLayersOfAPainting) {
  const Snapshot one = bent_sheet();
  const Eigen::Index vertices = one.rest->cols(), triangles = one.triangles->cols();
  Snapshot snapshot = test::undeformed(test::square_grid(6));
  Points rest(2, 2 * vertices), deformed(2, 2 * vertices);
  rest << *one.rest, one.rest->colwise() + Vec2(2, 1);
  deformed << one.deformed, one.deformed.colwise() + Vec2(2, 1);
  Triangles both(3, 2 * triangles);
  both << *one.triangles, one.triangles->array() + static_cast<int>(vertices);
  snapshot.rest = std::make_shared<const Points>(rest);
  snapshot.deformed = deformed;
  snapshot.triangles = std::make_shared<const Triangles>(both);
  snapshot.original_vertices = static_cast<int>(2 * vertices);
  const int count = static_cast<int>(vertices);
  FigureOptions options = figure_of({&Layers::fill, &Layers::boundary});
  options.parts = std::make_shared<const MeshParts>(
      MeshParts{{"front", 0, count, 1}, {"back", count, count, 0}});
  const auto levels = [](std::array<std::uint8_t, 4> colour) {
    return std::make_shared<const TextureLevels>(texture_levels(of_one_colour(colour)));
  };
  options.texture = std::make_shared<const TexturePieces>(
      TexturePieces{{levels({200, 40, 40, 255}), {{0.1, 0.1}, {0.5, 0.6}}},
                    {levels({40, 40, 200, 255}), {{0.3, 0.3}, {0.9, 0.9}}}});
  expect_like_the_picture(snapshot, options);
}

TEST(VectorFigure, IsLikeThePictureFromNearAndFarOfItsMiddle) {
  FigureOptions options = figure_of({&Layers::fill, &Layers::wireframe, &Layers::handles});
  options.style.line_width = 3;
  options.ground = GroundColour{200, 220, 180};
  for (const Camera& camera :
       {Camera{{2, 3}, 200}, Camera{{2.03, 3.02}, 1e7}, Camera{{40, 3}, 9}}) {
    options.camera = camera;
    expect_like_the_picture(bent_sheet(), options);
  }
}

TEST(VectorFigure, HidesWhatLiesBehindWhereLimbsCross) {
  FigureOptions options = figure_of({&Layers::fill, &Layers::boundary});
  options.camera = Camera{{0, 0}, 500};
  expect_like_the_picture(test::crossing_ribbon(), options);
  options.style.layers.fill = false;
  options.style.layers.heat = true;
  options.style.heat_scale = {1, 4};
  expect_like_the_picture(test::crossing_ribbon(), options);
}

/// True when the background is neither at a pixel of a picture nor beside it.
bool is_inside(const Image& picture, int x, int y, const GroundColour& ground) {
  const glm::vec4 colour(ground[0] / 255.0F, ground[1] / 255.0F, ground[2] / 255.0F, 1);
  for (int j = -1; j <= 1; ++j)
    for (int i = -1; i <= 1; ++i)
      if (test::difference(picture.at(x + i, y + j), colour) < 100) return false;
  return true;
}

/// How many pixels inside of the mesh the red background shows through.
int seams_in(const Image& drawn, const Image& picture, const GroundColour& red) {
  int count = 0;
  for (int y = 1; y + 1 < picture.height; ++y)
    for (int x = 1; x + 1 < picture.width; ++x) {
      const std::uint8_t *there = drawn.at(x, y), *here = picture.at(x, y);
      const bool is_redder = there[0] > here[0] + 15 && there[2] < here[2] - 4;
      count += is_redder && is_inside(picture, x, y, red) ? 1 : 0;
    }
  return count;
}

TEST(VectorFigure, HasNoSeamsBetweenTriangles) {
  constexpr GroundColour kRed{255, 0, 0};
  FigureOptions heat = figure_of({&Layers::heat});
  heat.has_legend = false;
  heat.style.heat_measure = HeatMeasure::area;
  for (FigureOptions options :
       {figure_of({&Layers::fill}), heat,
        with_image(figure_of({&Layers::fill}), of_one_colour({230, 230, 240, 255}))})
    for (const Snapshot& snapshot : {bent_sheet(), test::crossing_ribbon()}) {
      options.ground = kRed;
      const Image picture = render_figure(snapshot, options);
      for (const VectorFormat format : kFormats) {
        const auto drawn = test::rasterised(format, vector_figure(format, snapshot, options));
        if (!drawn) GTEST_SKIP() << "librsvg2-bin or poppler-utils is missing";
        EXPECT_EQ(seams_in(*drawn, picture, kRed), 0);
      }
    }
}

TEST(VectorFigure, OfAnSvgNamesItsSizeAndHasAPathForEachLineStyle) {
  FigureOptions options = figure_of({&Layers::boundary});
  options.style.background = Background::transparent;
  const std::string svg =
      vector_figure(VectorFormat::svg, bent_sheet(), options, {{"Scene", "a <b> & \"c\""}});
  EXPECT_NE(svg.find("viewBox=\"0 0 400 300\""), std::string::npos);
  EXPECT_NE(svg.find("width=\"400px\""), std::string::npos);
  EXPECT_NE(svg.find("<title>a &lt;b&gt; &amp; &quot;c&quot;</title>"), std::string::npos);
  EXPECT_EQ(occurrences(svg, "<path style=\"fill:none"), 1U) << "the boundary is one path";
  options.style.layers.fill = true;
  const std::string filled = vector_figure(VectorFormat::svg, bent_sheet(), options);
  EXPECT_EQ(occurrences(filled, "<path"), occurrences(svg, "<path") + 2)
      << "light and dark squares";
  EXPECT_EQ(occurrences(filled, "<image"), 0U) << "nothing is drawn as pixels";
}

TEST(VectorFigure, EmbedsAnImageOnceWhateverTheTriangles) {
  FigureOptions options = with_image(figure_of({&Layers::fill}), of_one_colour({9, 99, 9, 128}));
  options.view = FigureView::both;
  EXPECT_EQ(occurrences(vector_figure(VectorFormat::svg, bent_sheet(), options), "<image"), 1U);
  const std::string pdf = vector_figure(VectorFormat::pdf, bent_sheet(), options);
  EXPECT_EQ(occurrences(pdf, "/Subtype /Image"), 2U) << "its colours and its opacity";
}

TEST(VectorFigure, HasTheSameBytesEveryTimeAndNoDate) {
  const FigureOptions options =
      with_image(figure_of({&Layers::fill, &Layers::handles}), of_one_colour({9, 99, 9, 128}));
  for (const VectorFormat format : kFormats) {
    const std::string first = vector_figure(format, bent_sheet(), options, {{"Scene", "s"}});
    EXPECT_EQ(first, vector_figure(format, bent_sheet(), options, {{"Scene", "s"}}));
    EXPECT_EQ(first.find("Date"), std::string::npos);
  }
}

TEST(VectorFigure, ShowsTrianglesThatAreTurnedOver) {
  Snapshot snapshot = test::undeformed(test::square_grid(4));
  snapshot.deformed.col(5) = Vec2(2.6, 2.4);
  snapshot.folded_triangles = 3;
  expect_like_the_picture(snapshot, figure_of({&Layers::fill, &Layers::wireframe}));
}

/// All but flattens a triangle towards its side to another sheet, one after another.
TEST(VectorFigure, OfATriangleThatIsAllButFlatBesideAnotherSheetIsDrawnAtOnce) {
  const FigureOptions options = figure_of({&Layers::fill});
  const Snapshot valid = test::crossing_ribbon();
  const PlacedMesh mesh = placed_mesh(valid, {Pose::deformed, {{0, 0}, 100}, {400, 300}, nullptr});
  int count = 0;
  for (std::size_t t = 0; t < mesh.sheets.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const int other = mesh.neighbours[t][k];
      if (other < 0 || mesh.sheets[static_cast<std::size_t>(other)] == mesh.sheets[t]) continue;
      const auto corner = [&](std::size_t at) {
        return static_cast<int>(mesh.vertices_of(static_cast<int>(t))[at % 3]);
      };
      Snapshot flat = valid;
      const Vec2 middle = (flat.deformed.col(corner(k)) + flat.deformed.col(corner(k + 1))) / 2;
      auto top = flat.deformed.col(corner(k + 2));
      top = middle + 1e-9 * (Vec2(top) - middle);
      EXPECT_LT(vector_figure(VectorFormat::svg, flat, options).size(), 1000000U);
      ++count;
    }
  EXPECT_GT(count, 0) << "there are two sheets";
}

TEST(VectorFigure, ThatIsTooLargeIsRefusedBeforeItIsDrawn) {
  FigureOptions options = figure_of({&Layers::fill});
  options.width = 16385;
  const std::string words =
      test::error_of([&] { vector_figure(VectorFormat::svg, bent_sheet(), options); });
  EXPECT_NE(words.find("16385 × 300"), std::string::npos) << words;
}

TEST(VectorFigure, TakesNamesThatAreNoText) {
  const ImageTexts texts{{"Scene", std::string("a\x01\xFF") + "b"}};
  const std::string svg =
      vector_figure(VectorFormat::svg, bent_sheet(), figure_of({&Layers::fill}), texts);
  EXPECT_NE(svg.find("<title>a \uFFFDb</title>"), std::string::npos);
  EXPECT_EQ(test::error_of([&] {
              vector_figure(VectorFormat::pdf, bent_sheet(), figure_of({&Layers::fill}), texts);
            }),
            "");
}

}  // namespace
}  // namespace foldless
