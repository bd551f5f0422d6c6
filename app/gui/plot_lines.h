// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/plot.h"

namespace foldless {

/// The values of a curve that share a column of pixels: where they begin and end, and between what
/// they lie [framebuffer pixels].
struct CurveColumn {
  float x;
  float first;
  float last;
  float low;
  float high;
};

/// Draws a curve column by column; dashes go on from one to the next.
class CurvePen {
 public:
  CurvePen(ImDrawList& list, const PlotCurve& curve, float thickness);

  /// A line to where the column begins, and a stroke across it.
  void go_on(const CurveColumn& column);
  /// A dot at the end.
  void finish();

 private:
  void line_to(const ImVec2& point);
  void dashes(const ImVec2& from, const ImVec2& to);

  ImDrawList& list_;
  LineStyle style_;
  ImU32 colour_;
  float thickness_;
  float travelled_ = 0;  ///< along the curve [pixels]
  std::optional<ImVec2> last_;
};

}  // namespace foldless
