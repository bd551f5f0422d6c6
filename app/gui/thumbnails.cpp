// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/thumbnails.h"

#include <algorithm>
#include <glm/common.hpp>
#include <utility>

#include "render/render_target.h"

namespace foldless {
namespace {

constexpr double kHeightOfScale1 = 210;   // pixels, so that markers stay small
constexpr double kMarginOfHeight = 0.08;  // of the height, round the drawing

std::filesystem::file_time_type time_of(const std::filesystem::path& file) {
  std::error_code missing;
  return std::filesystem::last_write_time(file, missing);
}

/// Of the mesh and of where its handles should be.
Box drawing_box(const Snapshot& pose) {
  const Vec2 low = pose.deformed.rowwise().minCoeff(), high = pose.deformed.rowwise().maxCoeff();
  Box box{{low.x(), low.y()}, {high.x(), high.y()}};
  for (const Handle& handle : pose.handles) {
    const glm::dvec2 target{handle.target.x(), handle.target.y()};
    box = {glm::min(box.min, target), glm::max(box.max, target)};
  }
  return box;
}

Texture uploaded(const Image& image) {
  Texture texture;
  glBindTexture(GL_TEXTURE_2D, texture.id());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               image.pixels.data());
  glBindTexture(GL_TEXTURE_2D, 0);
  return texture;
}

}  // namespace

void Thumbnails::set_look(int width, int height, Theme theme) {
  if (width == width_ && height == height_ && theme == theme_) return;
  width_ = width;
  height_ = height;
  theme_ = theme;
  made_.clear();
}

ImTextureID Thumbnails::of(const std::filesystem::path& file) {
  const auto made = made_.find(file);
  if (made != made_.end() && made->second.changed == time_of(file)) {
    const auto& texture = made->second.texture;
    return texture ? reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture->id()))
                   : nullptr;
  }
  if (reading_ != file && std::ranges::find(wanted_, file) == wanted_.end())
    wanted_.push_back(file);
  return nullptr;
}

bool Thumbnails::update() {
  std::optional<Read> read;
  {
    const std::lock_guard lock(mutex_);
    read = std::exchange(read_, std::nullopt);
  }
  if (read) {
    Entry& entry = made_[read->file];
    entry.changed = time_of(read->file);
    entry.texture.reset();
    if (read->sketch.pose) entry.texture = draw(read->sketch);
    reading_.reset();
  }
  if (!reading_ && !wanted_.empty()) begin_next();
  return reading_.has_value();
}

void Thumbnails::begin_next() {
  reading_ = wanted_.front();
  wanted_.erase(wanted_.begin());
  job_.start(
      [this, read = std::make_shared<Read>(Read{*reading_, {}})](const std::stop_token& stop) {
        read->sketch = sketch_of(read->file);
        if (stop.stop_requested()) return;
        const std::lock_guard lock(mutex_);
        read_ = std::move(*read);
      });
}

Texture Thumbnails::draw(const FileSketch& sketch) {
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  if (!renderer_) renderer_.emplace();
  renderer_->clear_texture();
  renderer_->set_parts(sketch.parts);
  std::optional<Box> place;
  if (const auto& box = sketch.image_box)
    place = Box{{box->min.x(), box->min.y()}, {box->max.x(), box->max.y()}};
  if (sketch.image) renderer_->set_texture(*sketch.image, place);
  ViewOptions options;
  options.theme = theme_;
  options.checker_squares = 10;
  options.ui_scale = height_ / kHeightOfScale1;
  options.layers.wireframe = false;
  options.layers.boundary = !sketch.image;
  SceneView view;
  view.viewport = {0, 0, width_, height_};
  view.camera = fit_to_box(drawing_box(*sketch.pose), {width_, height_}, kMarginOfHeight * height_);
  RenderTarget target(width_, height_);
  target.bind();
  renderer_->draw(*sketch.pose, view, options);
  Texture texture = uploaded(target.read());
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(bound));
  return texture;
}

}  // namespace foldless
