// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "render/image.h"

namespace foldless {

/// What a film is, besides its pictures.
struct FilmOptions {
  double fps = 24;            ///< pictures a second, > 0
  bool loops = false;         ///< for ever; otherwise it is seen once
  std::size_t count = 1;      ///< pictures that will be added
  ImageTexts texts = {};      ///< see encode_png()
  bool power_of_two = false;  ///< sides of a sprite sheet
};

/// Moving pictures as the bytes of one file. Of a picture only what differs from the one before is
/// kept.
class Film {
 public:
  Film() = default;
  virtual ~Film() = default;
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;

  /// Whether some of the pictures are to be shown to sample() before the first is added.
  virtual bool wants_samples() const { return false; }
  virtual void sample(const Image&) {}
  /// The next picture; all have one size. Throws Error.
  virtual void add(const Image& image) = 0;
  /// The file. Precondition: as many pictures were added as were promised. Throws Error.
  virtual std::string finish() = 0;
};

/// An animated PNG [APNG]: exact colours and alpha. Programs that do not know it show the first
/// picture.
std::unique_ptr<Film> make_apng(const FilmOptions& options);
/// An animated GIF of 255 colours, made of the samples, and transparency.
std::unique_ptr<Film> make_gif(const FilmOptions& options);
/// An animated WebP, lossless.
std::unique_ptr<Film> make_animated_webp(const FilmOptions& options);

}  // namespace foldless
