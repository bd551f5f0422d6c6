// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "app/export/cairo.h"
#include "app/export/vector_figure.h"
#include "render/image.h"

namespace foldless {

struct CairoSurfaceDeleter {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using CairoSurface = std::unique_ptr<cairo_surface_t, CairoSurfaceDeleter>;

/// An SVG or PDF file in memory that is drawn by cairo. The same calls make the same bytes: there
/// is no date in it.
class VectorFile {
 public:
  /// A page of so many pixels, 96 an inch; they are the units of the drawing, y down.
  VectorFile(VectorFormat format, int width, int height);
  VectorFile(const VectorFile&) = delete;
  VectorFile& operator=(const VectorFile&) = delete;

  cairo_t* cairo() const { return cairo_.get(); }

  /// Ends the drawing and returns the file with what it says of itself. Throws Error when cairo
  /// could not draw it.
  std::string finish(const ImageTexts& texts);

 private:
  struct CairoDeleter {
    void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
  };

  VectorFormat format_;
  std::string bytes_;
  CairoSurface surface_;
  std::unique_ptr<cairo_t, CairoDeleter> cairo_;
};

}  // namespace foldless
