// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace foldless {

/// Rows of cells under a row of titles; numbers stand to the right.
class TextTable {
 public:
  explicit TextTable(std::vector<std::string> titles) : rows_{std::move(titles)} {}

  /// A row of as many cells as there are titles.
  void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  bool is_empty() const { return rows_.size() < 2; }

  /// Columns of equal width for a terminal, two blanks between them.
  std::string plain() const;
  std::string markdown() const;
  /// See latex_table().
  std::string latex() const;
  /// Commas between, quotation marks where need be.
  std::string csv() const;

 private:
  std::vector<std::vector<std::string>> rows_;  ///< the titles first
};

/// The number to so many significant digits, whatever the locale: `0.0123`, `1.4e-14`, `infinite`.
std::string number_text(double value, int digits = 3);

}  // namespace foldless
