// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "app/editor/canvas.h"
#include "app/editor/draft.h"
#include "core/mesh/stiffness.h"

namespace foldless {

/// The brush that makes parts of the drawing stiff: it is moved over the deformed mesh, and paints
/// the places of the rest mesh that are under it.
class StiffnessBrush {
 public:
  static constexpr double kLeastFactor = 0.1, kLargestFactor = 1000;
  static constexpr double kLeastRadius = 3, kLargestRadius = 300;  ///< [design pixels]

  /// Keeps a reference.
  explicit StiffnessBrush(Draft& draft) : draft_(draft) {}

  /// In the hand: a press paints.
  bool is_on() const { return is_on_; }
  void toggle() { is_on_ = !is_on_; }

  double factor() const { return factor_; }
  void set_factor(double factor);  ///< clamped
  double radius() const { return radius_; }
  void set_radius(double design_pixels);  ///< clamped

  // A gesture.

  /// `takes_back`: what is painted is as stiff as ever.
  void press(const Canvas& canvas, const Vec2& pixel, bool takes_back);
  void move(const Canvas& canvas, const Vec2& pixel);
  void release();  ///< what it painted becomes an undo step
  void cancel() { painted_.clear(); }

  /// Whether what is stiff should be seen: the brush is in the hand, or a stiff handle selected.
  bool is_tinted() const;

  bool can_clear() const { return draft_.document().stiffness != nullptr; }
  /// The whole drawing is as stiff as ever; an undo step.
  void clear();

  /// The factors of the triangles on screen, what the gesture has painted included; empty when all
  /// are 1. By triangle.
  const std::vector<float>& factors();

 private:
  struct Place {
    Vec2 pixel;
    std::optional<Vec2> at_rest;  ///< nothing beside the mesh
  };
  /// What factors_ were computed of.
  struct Seen {
    std::shared_ptr<const Stiffness> stiffness;
    std::vector<StiffDisk> disks;
    std::vector<int> vertices;  ///< of the disks
    std::uint64_t revision = 0;
    Eigen::Index points = 0;
    bool operator==(const Seen&) const = default;
  };

  std::optional<Vec2> rest_place(const Canvas& canvas, const Vec2& pixel);
  std::vector<StiffStroke> strokes() const;
  void edit(const std::string& label, std::vector<StiffStroke> strokes);

  Draft& draft_;
  bool is_on_ = false;
  double factor_ = 100;
  double radius_ = 24;  ///< [design pixels]
  StiffStroke next_;    ///< what a new line begins with
  std::vector<StiffStroke> painted_;
  Place last_{Vec2::Zero(), std::nullopt};
  Seen seen_;
  std::vector<float> factors_;
};

}  // namespace foldless
