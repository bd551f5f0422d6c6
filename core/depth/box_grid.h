// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace foldless {

/// Boxes in the square cells of a grid over all of them, to find those near another box. CGAL's
/// box_intersection_d takes 2.5 to 8 times as long (2,000 to 50,000 triangles), in every frame.
class BoxGrid {
 public:
  /// Keeps a reference.
  explicit BoxGrid(const std::vector<Eigen::AlignedBox2d>& boxes) : boxes_(boxes) {
    double extents = 0;
    for (const auto& box : boxes) {
      whole_.extend(box);
      extents += box.sizes().sum();
    }
    if (boxes.empty()) return;
    const double most = kMostCells * static_cast<double>(boxes.size());
    cell_ = std::max({extents / static_cast<double>(boxes.size()),
                      std::sqrt(whole_.sizes().prod() / most), whole_.sizes().maxCoeff() / most});
    if (!(cell_ > 0)) cell_ = 1;
    while (cells_of_boxes() > most) cell_ *= 2;
    columns_ = index(whole_.max().x(), 0) + 1;
    first_.assign(static_cast<std::size_t>(columns_ * (index(whole_.max().y(), 1) + 1)) + 1, 0);
    for (const auto& box : boxes)
      for_each_cell(box, [this](std::size_t cell) { ++first_[cell + 1]; });
    for (std::size_t cell = 1; cell < first_.size(); ++cell) first_[cell] += first_[cell - 1];
    entries_.resize(static_cast<std::size_t>(first_.back()));
    std::vector<int> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < boxes.size(); ++i)
      for_each_cell(boxes[i], [&](std::size_t cell) {
        entries_[static_cast<std::size_t>(next[cell]++)] = static_cast<int>(i);
      });
  }

  /// Every box that touches this one, by index; perhaps more than once.
  template <class Function>
  void for_each_near(const Eigen::AlignedBox2d& box, const Function& function) const {
    if (boxes_.empty() || !box.intersects(whole_)) return;
    for_each_cell(box.intersection(whole_), [&](std::size_t cell) {
      for (int i = first_[cell]; i < first_[cell + 1]; ++i) {
        const int found = entries_[static_cast<std::size_t>(i)];
        if (boxes_[static_cast<std::size_t>(found)].intersects(box)) function(found);
      }
    });
  }

 private:
  /// For every box at most: cells in all, and cells that boxes lie in.
  static constexpr double kMostCells = 8;

  std::int64_t index(double coordinate, int axis) const {
    return static_cast<std::int64_t>((coordinate - whole_.min()[axis]) / cell_);
  }

  double cells_of_boxes() const {
    double count = 0;
    for (const auto& box : boxes_)
      count += (box.sizes().x() / cell_ + 1) * (box.sizes().y() / cell_ + 1);
    return count;
  }

  template <class Function>
  void for_each_cell(const Eigen::AlignedBox2d& box, const Function& function) const {
    for (auto y = index(box.min().y(), 1); y <= index(box.max().y(), 1); ++y)
      for (auto x = index(box.min().x(), 0); x <= index(box.max().x(), 0); ++x)
        function(static_cast<std::size_t>(y * columns_ + x));
  }

  const std::vector<Eigen::AlignedBox2d>& boxes_;
  Eigen::AlignedBox2d whole_;
  double cell_ = 1;
  std::int64_t columns_ = 0;
  std::vector<int> first_;  ///< cell → its entries
  std::vector<int> entries_;
};

}  // namespace foldless
