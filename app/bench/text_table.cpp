// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/text_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "core/files/latex_table.h"

namespace foldless {
namespace {

/// Characters, not bytes.
std::size_t length_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

bool is_number(std::string_view cell) {
  return cell.find_first_of("0123456789") != std::string_view::npos &&
         cell.find_first_not_of("0123456789.,+-e/ %") == std::string_view::npos;
}

std::string padded(const std::string& cell, std::size_t width) {
  const std::string blanks(width - std::min(width, length_of(cell)), ' ');
  return is_number(cell) ? blanks + cell : cell + blanks;
}

std::string quoted(const std::string& cell) {
  if (cell.find_first_of(",\"\n") == std::string::npos) return cell;
  std::string result = "\"";
  for (const char c : cell) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + '"';
}

}  // namespace

std::string TextTable::plain() const {
  std::vector<std::size_t> widths(rows_.front().size());
  for (const auto& row : rows_)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], length_of(row[i]));
  std::string text;
  for (const auto& row : rows_) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) line += padded(row[i], widths[i]) + "  ";
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

std::string TextTable::markdown() const {
  std::string text;
  for (const auto& row : rows_) {
    text += '|';
    for (const std::string& cell : row) text += ' ' + cell + " |";
    text += '\n';
    if (&row != &rows_.front()) continue;
    text += '|';
    for (std::size_t i = 0; i < row.size(); ++i) text += "---|";
    text += '\n';
  }
  return text;
}

std::string TextTable::latex() const { return latex_table(rows_); }

std::string TextTable::csv() const {
  std::string text;
  for (const auto& row : rows_)
    for (std::size_t i = 0; i < row.size(); ++i)
      text += quoted(row[i]) + (i + 1 == row.size() ? '\n' : ',');
  return text;
}

std::string number_text(double value, int digits) {
  if (!std::isfinite(value)) return std::isnan(value) ? "—" : "infinite";
  std::array<char, 64> buffer;
  const auto format = std::abs(value) >= 0.001 && std::abs(value) < 1e6
                          ? std::chars_format::fixed
                          : std::chars_format::general;
  const double magnitude = value == 0 ? 0 : std::floor(std::log10(std::abs(value)));
  const int precision = format == std::chars_format::fixed
                            ? std::max(0, digits - 1 - static_cast<int>(magnitude))
                            : digits;
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format, precision);
  return {buffer.data(), end.ptr};
}

}  // namespace foldless
