// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/latex_table.h"

#include <gtest/gtest.h>

namespace foldless {
namespace {

TEST(LatexTable, HasTheRulesOfBooktabsAndNumbersToTheRight) {
  EXPECT_EQ(latex_table({{"scene", "δ", "H"}, {"disk", "1e-05", "12"}, {"bar", "–", "7"}}),
            "% needs \\usepackage{booktabs}\n"
            "\\begin{tabular}{lrr}\n"
            "\\toprule\n"
            "scene & $\\delta$ & H \\\\\n"
            "\\midrule\n"
            "disk & $1 \\cdot 10^{-5}$ & $12$ \\\\\n"
            "bar & -- & $7$ \\\\\n"
            "\\bottomrule\n"
            "\\end{tabular}\n");
}

TEST(LatexTable, EscapesWhatHasAMeaningInLatex) {
  EXPECT_EQ(latex_text("a_b & 5 % #1 {x} $y$ \\z ~ ^"),
            "a\\_b \\& 5 \\% \\#1 \\{x\\} \\$y\\$ \\textbackslash{}z \\textasciitilde{} "
            "\\textasciicircum{}");
  EXPECT_EQ(latex_text("‖∇E‖²"), "$\\|$$\\nabla$E$\\|$$^2$");
}

TEST(LatexTable, WritesExponentsOfEitherSign) {
  const std::string table = latex_table({{"n"}, {"1.5e+20"}, {"-2e-7"}});
  EXPECT_NE(table.find("$1.5 \\cdot 10^{20}$"), std::string::npos) << table;
  EXPECT_NE(table.find("$-2 \\cdot 10^{-7}$"), std::string::npos);
}

TEST(LatexTable, WithoutRowsIsStillATable) {
  EXPECT_NE(latex_table({{"a", "b"}}).find("{ll}"), std::string::npos);
}

}  // namespace
}  // namespace foldless
