// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/latex_table.h"

#include <array>
#include <cstddef>

#include "core/files/text_lines.h"

namespace foldless {
namespace {

/// A sign and what prints it.
struct Sign {
  std::string_view text, latex;
};

constexpr std::array<Sign, 17> kSigns{{{"\\", "\\textbackslash{}"},
                                       {"{", "\\{"},
                                       {"}", "\\}"},
                                       {"$", "\\$"},
                                       {"&", "\\&"},
                                       {"#", "\\#"},
                                       {"%", "\\%"},
                                       {"_", "\\_"},
                                       {"^", "\\textasciicircum{}"},
                                       {"~", "\\textasciitilde{}"},
                                       {"δ", "$\\delta$"},
                                       {"η", "$\\eta$"},
                                       {"∇", "$\\nabla$"},
                                       {"‖", "$\\|$"},
                                       {"²", "$^2$"},
                                       {"–", "--"},
                                       {"—", "---"}}};

/// A number that is all of a cell; a power of ten where it has an exponent.
std::string latex_number(std::string_view cell) {
  const std::size_t e = cell.find('e');
  if (e == std::string_view::npos) return '$' + std::string(cell) + '$';
  const auto exponent = parse_integer(cell.substr(e + (cell[e + 1] == '+' ? 2 : 1)));
  std::string text = "$";
  text += cell.substr(0, e);
  text += " \\cdot 10^{";
  text += std::to_string(exponent.value_or(0));
  return text + "}$";
}

bool is_of_numbers(const std::vector<std::vector<std::string>>& rows, std::size_t column) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const std::string& cell = rows[i][column];
    const bool has_none = cell.empty() || cell == "–" || cell == "—";
    if (!has_none && cell.find_first_not_of("0123456789.,+-e/ %") != std::string::npos)
      return false;
  }
  return rows.size() > 1;
}

void append_latex_row(std::string& text, const std::vector<std::string>& row) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (i > 0) text += " & ";
    text += parse_number(row[i]) ? latex_number(row[i]) : latex_text(row[i]);
  }
  text += " \\\\\n";
}

}  // namespace

std::string latex_text(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const Sign* found = nullptr;
    for (const Sign& sign : kSigns)
      if (text.starts_with(sign.text)) found = &sign;
    result += found ? found->latex : text.substr(0, 1);
    text.remove_prefix(found ? found->text.size() : 1);
  }
  return result;
}

std::string latex_table(const std::vector<std::vector<std::string>>& rows) {
  std::string text = "% needs \\usepackage{booktabs}\n\\begin{tabular}{";
  for (std::size_t column = 0; column < rows.front().size(); ++column)
    text += is_of_numbers(rows, column) ? 'r' : 'l';
  text += "}\n\\toprule\n";
  append_latex_row(text, rows.front());
  text += "\\midrule\n";
  for (std::size_t i = 1; i < rows.size(); ++i) append_latex_row(text, rows[i]);
  return text + "\\bottomrule\n\\end{tabular}\n";
}

}  // namespace foldless
