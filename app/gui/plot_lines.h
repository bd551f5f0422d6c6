// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/plot.h"

namespace foldless {

/// Draws a curve piece by piece; dashes go on from one piece to the next.
class CurvePen {
 public:
  CurvePen(ImDrawList& list, const PlotCurve& curve, float thickness);

  void line_to(const ImVec2& point);
  /// A stroke across a column that holds many values.
  void column(float x, float low, float high);
  /// A dot at the end.
  void finish();

 private:
  void dashes(const ImVec2& from, const ImVec2& to);

  ImDrawList& list_;
  LineStyle style_;
  ImU32 colour_;
  float thickness_;
  float travelled_ = 0;  ///< along the curve [pixels]
  std::optional<ImVec2> last_;
};

}  // namespace foldless
