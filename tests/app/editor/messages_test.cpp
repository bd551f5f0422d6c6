// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/messages.h"

#include <gtest/gtest.h>

namespace foldless::test {
namespace {

TEST(Messages, AToastGoesAwayByTheClockAndAnErrorStaysLonger) {
  Messages messages;
  messages.tick(10);
  messages.toast(ToastKind::notice, "Saved");
  messages.toast(ToastKind::error, "Not saved");
  EXPECT_EQ(messages.next_wake(), 14);
  messages.tick(14);
  ASSERT_EQ(messages.toasts().size(), 1U);
  EXPECT_EQ(messages.toasts().front().text, "Not saved");
  messages.tick(22);
  EXPECT_TRUE(messages.toasts().empty());
  EXPECT_FALSE(messages.next_wake());
}

TEST(Messages, WhatIsSaidAgainIsShownOnce) {
  Messages messages;
  messages.toast(ToastKind::notice, "Saved");
  messages.tick(3);
  messages.toast(ToastKind::notice, "Saved");
  ASSERT_EQ(messages.toasts().size(), 1U);
  EXPECT_EQ(messages.next_wake(), 7);
}

TEST(Messages, AllThatWereShownAreLogged) {
  Messages messages;
  messages.tick(5);
  messages.toast(ToastKind::notice, "Saved");
  messages.tick(100);
  messages.toast(ToastKind::error, "Not saved");
  ASSERT_EQ(messages.log().size(), 2U);
  EXPECT_EQ(messages.log()[0].text, "Saved");
  EXPECT_EQ(messages.log()[0].time, 5);
  EXPECT_EQ(messages.log()[1].kind, ToastKind::error);
  for (int i = 0; i < 2000; ++i) messages.toast(ToastKind::notice, std::to_string(i));
  EXPECT_EQ(messages.log().size(), Messages::kMostLogged);
  EXPECT_EQ(messages.log().back().text, "1999");
}

TEST(Messages, ARequestAndARedrawAreGivenOnce) {
  Messages messages;
  messages.take_redraw();
  messages.request(Request::quit);
  EXPECT_TRUE(messages.take_redraw());
  EXPECT_FALSE(messages.take_redraw());
  EXPECT_EQ(messages.take_requests(), std::vector{Request::quit});
  EXPECT_TRUE(messages.take_requests().empty());
}

TEST(Messages, OnlyAToastThatGoesAwayMakesThePictureOld) {
  Messages messages;
  messages.toast(ToastKind::notice, "Saved");
  messages.take_redraw();
  messages.tick(1);
  EXPECT_FALSE(messages.take_redraw());
  messages.tick(5);
  EXPECT_TRUE(messages.take_redraw());
}

}  // namespace
}  // namespace foldless::test
