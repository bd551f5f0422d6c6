// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/offscreen.h"

#include <glad/gl.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "render/render_target.h"
#include "tests/support/pixels.h"

namespace foldless {
namespace {

void fill(float r, float g, float b, float a) {
  glClearColor(r, g, b, a);
  glClear(GL_COLOR_BUFFER_BIT);
}

TEST(Offscreen, OffersOpenGl33Core) {
  const Offscreen screen(8, 8);
  GLint major = 0, minor = 0, profile = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
  EXPECT_GE(10 * major + minor, 33);
  EXPECT_EQ(profile, GL_CONTEXT_CORE_PROFILE_BIT);
}

TEST(Offscreen, ReadsWhatWasDrawnRowsFromTheTop) {
  Offscreen screen(10, 6);
  fill(1, 0, 0, 1);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 5, 10, 1);  // GL counts rows from below
  fill(0, 1, 0, 1);
  glDisable(GL_SCISSOR_TEST);
  const Image image = screen.read();
  EXPECT_EQ(test::difference(image.at(4, 0), {0, 1, 0, 1}), 0);
  EXPECT_EQ(test::difference(image.at(4, 1), {1, 0, 0, 1}), 0);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(Offscreen, AlphaComesBackStraight) {
  Offscreen screen(4, 4);
  fill(0.25F, 0.125F, 0, 0.5F);
  EXPECT_LE(test::difference(screen.read().at(1, 1), {0.5F, 0.25F, 0, 0.5F}), 2);
}

TEST(Offscreen, ResizeMakesAPictureOfTheNewSize) {
  Offscreen screen(8, 8);
  screen.resize(31, 17);
  const Image image = screen.read();
  EXPECT_EQ(image.width, 31);
  EXPECT_EQ(image.height, 17);
}

TEST(Offscreen, TwoContextsTakeTurns) {
  Offscreen first(4, 4);
  fill(1, 0, 0, 1);
  {
    Offscreen second(4, 4);
    fill(0, 0, 1, 1);
    EXPECT_EQ(test::difference(second.read().at(0, 0), {0, 0, 1, 1}), 0);
  }
  first.make_current();
  first.bind();
  EXPECT_EQ(test::difference(first.read().at(0, 0), {1, 0, 0, 1}), 0);
}

TEST(RenderTarget, AsksForNoMoreSamplesThanThereAre) {
  const Offscreen screen(4, 4);
  GLint most = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  EXPECT_EQ(RenderTarget(8, 8, 1024).samples(), most);
  EXPECT_EQ(RenderTarget(8, 8, 1).samples(), 1);
}

TEST(RenderTarget, RefusesSizesThatCannotBe) {
  const Offscreen screen(4, 4);
  EXPECT_THROW(RenderTarget(0, 5), Error);
  EXPECT_THROW(RenderTarget(5, -1), Error);
  EXPECT_THROW(RenderTarget(1 << 20, 1 << 20), Error);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

}  // namespace
}  // namespace foldless
