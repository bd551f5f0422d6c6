// SPDX-License-Identifier: GPL-3.0-or-later
// The keyboard in the list of a combo box: that of the energies, which is opened by the mouse.
#include <gtest/gtest.h>

#include "core/energy/densities.h"
#include "core/mesh/generate.h"
#include "tests/app/gui/headless_editor.h"

namespace foldless::test {
namespace {

class ChoiceList : public testing::Test {
 protected:
  ChoiceList() {
    headless_.editor().files().open_shape(bar(4, 1, 2), "bar");
    headless_.calm_down();
  }
  void choose_by(Key key) {
    open();
    headless_.key(key);
    headless_.key(Key::enter);
  }
  void open() {
    headless_.click(headless_.find_words(std::string(energy().title)).value());
    headless_.move({500, 300});  // what it is over would have the focus
  }
  const Density& energy() { return *headless_.editor().document().energy; }

  HeadlessEditor headless_;
};

TEST_F(ChoiceList, ArrowsBeginAtTheEntryThatIsChosen) {
  headless_.editor().edits().set_energy(densities()[2]);
  headless_.calm_down();
  choose_by(Key::down);
  EXPECT_EQ(&energy(), &densities()[3]);
  choose_by(Key::up);
  EXPECT_EQ(&energy(), &densities()[2]);
}

TEST_F(ChoiceList, HomeEndAndPagesGoToTheEnds) {
  choose_by(Key::end);
  EXPECT_EQ(&energy(), &densities().back());
  choose_by(Key::home);
  EXPECT_EQ(&energy(), &densities().front());
  choose_by(Key::page_down);
  EXPECT_EQ(&energy(), &densities().back());
  choose_by(Key::page_up);
  EXPECT_EQ(&energy(), &densities().front());
}

TEST_F(ChoiceList, ALetterLeadsToTheNextEntryThatBeginsWithIt) {
  headless_.editor().edits().set_energy(*find_density("symmetric-dirichlet"));
  headless_.calm_down();
  for (const auto& [letter, name] : {std::pair{"l", "lscm"}, {"G", "green-strain"}}) {
    open();
    headless_.type(letter);
    headless_.key(Key::enter);
    EXPECT_EQ(energy().name, name);
  }
  open();
  headless_.type("x");
  headless_.key(Key::escape);
  EXPECT_EQ(energy().name, "green-strain") << "none begins with it";
}

TEST_F(ChoiceList, TheSameLetterAgainLeadsFurther) {
  headless_.click(headless_.find_words("Foldless").value());
  headless_.move({500, 300});
  headless_.type("r");
  headless_.type("r");
  headless_.key(Key::enter);
  EXPECT_EQ(headless_.editor().document().parameters.method, "paper-flip") << "the second of three";
}

TEST_F(ChoiceList, TypingInItRunsNoCommands) {
  open();
  headless_.type("d");
  headless_.key(Key::d);  // as the window sends both
  EXPECT_EQ(headless_.editor().view().beside(), Beside::nothing);
}

}  // namespace
}  // namespace foldless::test
