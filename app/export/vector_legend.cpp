// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/vector_legend.h"

#include "render/colormap.h"

namespace foldless {
namespace {

constexpr int kStops = 32;  // of the gradient

void draw_colours(const VectorPane& pane, const LegendBar& bar) {
  cairo_pattern_t* colours = cairo_pattern_create_linear(0, bar.top + bar.height, 0, bar.top);
  for (int stop = 0; stop <= kStops; ++stop) {
    const double t = static_cast<double>(stop) / kStops;
    const glm::vec3 colour = viridis(static_cast<float>(t));
    cairo_pattern_add_color_stop_rgb(colours, t, colour.r, colour.g, colour.b);
  }
  cairo_rectangle(pane.cairo, bar.left, bar.top, bar.width, bar.height);
  cairo_set_source(pane.cairo, colours);
  cairo_fill(pane.cairo);
  cairo_pattern_destroy(colours);
}

}  // namespace

void draw_legend(const VectorPane& pane, const Legend& legend) {
  const LegendBar& bar = legend.bar;
  draw_colours(pane, bar);
  // On the middle of pixels, where the picture has whole ones.
  cairo_rectangle(pane.cairo, bar.left - 0.5, bar.top - 0.5, bar.width + 1, bar.height + 1);
  for (const double y : legend.marks) {
    cairo_move_to(pane.cairo, bar.left + bar.width, y);
    cairo_rel_line_to(pane.cairo, legend.mark_length, 0);
  }
  set_line(pane, {.colour = legend.colour, .width = static_cast<float>(1 / pane.ui_scale)});
  cairo_stroke(pane.cairo);
  cairo_set_line_cap(pane.cairo, CAIRO_LINE_CAP_ROUND);
  for (const LegendText& text : legend.texts) {
    for (const StrokeLine& line : stroke_lines(text.words, text.place)) {
      cairo_move_to(pane.cairo, line.a.x, line.a.y);
      cairo_line_to(pane.cairo, line.b.x, line.b.y);
    }
    cairo_set_line_width(pane.cairo, stroke_width(text.place.height));
    cairo_stroke(pane.cairo);
  }
}

}  // namespace foldless
