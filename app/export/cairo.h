// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>

#include "render/late_function.h"

namespace foldless {

/// cairo's functions that the vector figures call; within this namespace they stand before cairo's
/// declarations.
inline constexpr LateLibrary kCairo{"libcairo.so.2", "figures cannot be drawn", "libcairo2"};

// NOLINTBEGIN(readability-identifier-naming): the library's own names
#define FOLDLESS_LATE(name) \
  inline constinit const LateFunction<decltype(::name)> name(kCairo, #name)

FOLDLESS_LATE(cairo_arc);
FOLDLESS_LATE(cairo_clip);
FOLDLESS_LATE(cairo_close_path);
FOLDLESS_LATE(cairo_create);
FOLDLESS_LATE(cairo_destroy);
FOLDLESS_LATE(cairo_fill);
FOLDLESS_LATE(cairo_fill_preserve);
FOLDLESS_LATE(cairo_image_surface_create);
FOLDLESS_LATE(cairo_image_surface_get_data);
FOLDLESS_LATE(cairo_image_surface_get_height);
FOLDLESS_LATE(cairo_image_surface_get_stride);
FOLDLESS_LATE(cairo_image_surface_get_width);
FOLDLESS_LATE(cairo_line_to);
FOLDLESS_LATE(cairo_move_to);
FOLDLESS_LATE(cairo_new_sub_path);
FOLDLESS_LATE(cairo_paint);
FOLDLESS_LATE(cairo_pattern_add_color_stop_rgb);
FOLDLESS_LATE(cairo_pattern_create_linear);
FOLDLESS_LATE(cairo_pattern_destroy);
FOLDLESS_LATE(cairo_pdf_surface_create_for_stream);
FOLDLESS_LATE(cairo_pdf_surface_set_metadata);
FOLDLESS_LATE(cairo_rectangle);
FOLDLESS_LATE(cairo_rel_line_to);
FOLDLESS_LATE(cairo_restore);
FOLDLESS_LATE(cairo_save);
FOLDLESS_LATE(cairo_scale);
FOLDLESS_LATE(cairo_set_dash);
FOLDLESS_LATE(cairo_set_fill_rule);
FOLDLESS_LATE(cairo_set_line_cap);
FOLDLESS_LATE(cairo_set_line_width);
FOLDLESS_LATE(cairo_set_source);
FOLDLESS_LATE(cairo_set_source_rgba);
FOLDLESS_LATE(cairo_set_source_surface);
FOLDLESS_LATE(cairo_show_page);
FOLDLESS_LATE(cairo_status);
FOLDLESS_LATE(cairo_status_to_string);
FOLDLESS_LATE(cairo_stroke);
FOLDLESS_LATE(cairo_surface_destroy);
FOLDLESS_LATE(cairo_surface_finish);
FOLDLESS_LATE(cairo_surface_mark_dirty);
FOLDLESS_LATE(cairo_surface_status);
FOLDLESS_LATE(cairo_svg_surface_create_for_stream);
FOLDLESS_LATE(cairo_svg_surface_set_document_unit);
FOLDLESS_LATE(cairo_transform);
FOLDLESS_LATE(cairo_translate);

#undef FOLDLESS_LATE
// NOLINTEND(readability-identifier-naming)

}  // namespace foldless
