// SPDX-License-Identifier: GPL-3.0-or-later
// Sessions: written, read, replayed.
#include "app/gui/replay.h"

#include <gtest/gtest.h>

#include "app/gui/session_file.h"
#include "app/gui/session_recorder.h"
#include "core/error.h"
#include "core/files/atomic_file.h"
#include "render/image.h"
#include "tests/app/gui/headless_editor.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

constexpr std::string_view kScene = R"({"energy": "arap", "handles": [],
  "mesh": {"vertices": [[0,0],[1,0],[2,0],[0,1],[1,1],[2,1],[0,2],[1,2],[2,2]],
           "triangles": [[0,1,4],[0,4,3],[1,2,5],[1,5,4],[3,4,7],[3,7,6],[4,5,8],[4,8,7]]}})";

class Sessions : public testing::Test {
 protected:
  Sessions() { folder_.write("scene.json", std::string(kScene)); }

  std::filesystem::path write(const std::string& lines) {
    return folder_.write("session.jsonl",
                         R"({"session": 1, "size": [900, 600], "file": "scene.json"})"
                         "\n" +
                             lines);
  }
  int replay(const std::string& lines, const std::string& shots = "shots") {
    return replay_session({write(lines), folder_ / shots});
  }
  Image shot(const std::string& name, const std::string& shots = "shots") {
    return load_image(folder_ / shots / (name + ".png"));
  }
  std::string error(const std::string& lines) {
    try {
      replay(lines);
    } catch (const Error& error) {
      const std::string what = error.what();
      return what.substr(what.find("session.jsonl"));
    }
    return "";
  }

  TemporaryFolder folder_;
};

/// Two handles, one of which is dragged.
const std::string kDrag = R"(
{"t": 1, "press": "left", "at": [300, 400]}
{"t": 1.1, "release": "left", "at": [300, 400]}
{"t": 2, "press": "left", "at": [550, 150]}
{"t": 2.1, "move": [560, 180]}
{"t": 2.2, "move": [600, 260]}
{"t": 2.3, "release": "left", "at": [600, 260]}
{"t": 9, "move": [450, 5]}
{"t": 60, "shot": "dragged"}
)";

TEST_F(Sessions, AreReplayedToTheSamePixels) {
  EXPECT_EQ(replay(R"({"shot": "before"})" + kDrag), 2);
  EXPECT_EQ(replay(kDrag, "again"), 1);
  const Image before = shot("before"), dragged = shot("dragged");
  EXPECT_EQ(dragged.width, 900);
  EXPECT_EQ(dragged.height, 600);
  EXPECT_GT(differing_pixels(before, dragged), 5000);
  EXPECT_EQ(differing_pixels(dragged, shot("dragged", "again")), 0);
}

TEST_F(Sessions, KeysAndTypedTextDoWhatTheyDoInTheWindow) {
  EXPECT_EQ(replay(R"({"t": 1, "key": "2"}
{"t": 1.1, "key_up": "2"}
{"t": 2, "shot": "without wire"}
{"t": 3, "held": ["ctrl"]}
{"t": 3.1, "key": "K", "held": ["ctrl"]}
{"t": 3.2, "key_up": "K"}
{"t": 3.3, "held": []}
{"t": 4, "type": "wireframe"}
{"t": 5, "key": "Enter"}
{"t": 5.1, "key_up": "Enter"}
{"t": 60, "shot": "with wire"})"),
            2);
  EXPECT_GT(differing_pixels(shot("without wire"), shot("with wire")), 500);
}

TEST_F(Sessions, TheWindowMayChangeItsSize) {
  replay_session({write(R"({"t": 1, "shot": "first"}
{"t": 2, "size": [700, 500]}
{"t": 3, "shot": "second"})"),
                  folder_ / "shots", Extent{640, 480}});
  EXPECT_EQ(shot("first").width, 640);
  EXPECT_EQ(shot("second").width, 700);
}

TEST_F(Sessions, ASampleIsOpenedAsACopyThatIsNeverOverwritten) {
  const std::string save = R"({"t": 1, "key": "S", "held": ["ctrl"]}
{"t": 1.1, "key_up": "S"}
{"t": 2, "shot": "asks"})";
  const auto path = folder_.write(
      "session.jsonl",
      first_line({{900, 600}, {900, 600}}, {folder_ / "scene.json", true}, folder_.path()) + save);
  EXPECT_TRUE(read_session(path).start.is_sample);
  replay_session({path, folder_ / "shots"});
  EXPECT_EQ(read_file(folder_ / "scene.json"), kScene) << "Ctrl+S asks where to";
}

TEST_F(Sessions, WhatCannotBeOpenedIsAnError) {
  std::filesystem::remove(folder_ / "scene.json");
  EXPECT_THROW(replay(R"({"t": 1, "shot": "one"})"), Error);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "shots/one.png"));
}

TEST_F(Sessions, QuittingEndsThem) {
  EXPECT_EQ(replay(R"({"t": 1, "shot": "one"}
{"t": 2, "key": "Q", "held": ["ctrl"]}
{"t": 3, "shot": "two"})"),
            1);
}

TEST_F(Sessions, WhatIsWrongIsSaidWithItsLine) {
  EXPECT_EQ(error("{\"t\": 1, \"press\": \"thumb\", \"at\": [1, 2]}"),
            "session.jsonl:2: [1].press is 'thumb', but left, right or middle is needed");
  EXPECT_EQ(error("\n\n{\"t\": 1, \"key\": \"Any\"}"),
            "session.jsonl:4: [1].key is 'Any', which is no key");
  EXPECT_EQ(error("{\"t\": 1}"),
            "session.jsonl:2: [1] has no event, such as move, press, key or shot");
  EXPECT_EQ(error("{\"t\": 1, \"shot\": \"../x\"}"),
            "session.jsonl:2: [1].shot is '../x', but the name of a file without its folder is "
            "needed");
  EXPECT_EQ(error("{\"t\": 1, \"size\": [0, 5]}"),
            "session.jsonl:2: [1].size is an array of length 2, but a width and a height from 1 to "
            "8192 pixels "
            "are needed");
  EXPECT_NE(error("{\"t\": 1,"), "");
  folder_.write("empty.jsonl", "");
  EXPECT_THROW(read_session(folder_ / "empty.jsonl"), Error);
  EXPECT_THROW(read_session(folder_ / "none.jsonl"), Error);
}

TEST_F(Sessions, WhatWasRecordedIsReadAgain) {
  const std::vector<UiEvent> events{
      InputEvent(PointerMoved{{1.5, 2}, {.shift = true}}),
      InputEvent(PointerPressed{Button::middle, {3, 4}, {.control = true, .alt = true}}),
      InputEvent(PointerReleased{Button::right, {3, 4}, {}}),
      InputEvent(WheelTurned{-1.25, {5, 6}}),
      InputEvent(KeyPressed{Key::page_down, {.alt = true}, true}),
      InputEvent(KeyReleased{Key::backslash}),
      InputEvent(FilesDropped{{folder_ / "a \"b\".png"}}),
      InputEvent(FocusLost{}),
      CharacterTyped{U'é'},
      CharacterTyped{U'狐'},
      ModifiersHeld{{.shift = true}},
      WindowLeft{}};
  const auto path = folder_ / "recorded.jsonl";
  SessionRecorder recorder(path);
  const SessionWindow window{{800, 600}, {400, 300}, 2};
  recorder.follow(0.5, window, {folder_ / "scene.json"});
  for (std::size_t i = 0; i < events.size(); ++i)
    recorder.add(1 + static_cast<double>(i), events[i]);
  recorder.follow(50, window, {});
  recorder.follow(51, {{801, 600}, {801, 600}, 1}, {});
  recorder.add(52, InputEvent(KeyPressed{Key::f12, {.shift = true}, false}));

  const SessionFile session = read_session(path);
  EXPECT_EQ(session.window, window);
  EXPECT_EQ(session.start.file, folder_ / "scene.json");
  EXPECT_FALSE(session.start.is_sample);
  ASSERT_EQ(session.entries.size(), events.size() + 2);
  for (std::size_t i = 0; i < events.size(); ++i) {
    const SessionEntry& entry = session.entries[i];
    EXPECT_EQ(entry.time, 1 + static_cast<double>(i));
    EXPECT_EQ(entry.line, static_cast<int>(i) + 2);
    ASSERT_TRUE(std::holds_alternative<UiEvent>(entry.event)) << i;
    EXPECT_EQ(line_of(0, entry.event), line_of(0, events[i])) << i;
  }
  EXPECT_EQ(std::get<SessionWindow>(session.entries[events.size()].event).framebuffer.width, 801);
  EXPECT_EQ(std::get<Shot>(session.entries.back().event).name, "0001");
}

TEST_F(Sessions, WhatCannotBeRecordedIsSaidAndNoMoreIsTried) {
  EXPECT_THROW(SessionRecorder(folder_ / "none/session.jsonl"), Error);
  SessionRecorder recorder("/dev/full");
  ASSERT_TRUE(recorder.is_on());
  EXPECT_THROW(recorder.follow(0, {{8, 8}, {8, 8}, 1}, {}), Error);
  EXPECT_FALSE(recorder.is_on());
  recorder.add(1, WindowLeft{});
}

TEST_F(Sessions, EveryKeyHasANameOfItsOwn) {
  for (int i = 1; i <= static_cast<int>(Key::right_bracket); ++i) {
    const auto key = static_cast<Key>(i);
    const auto path =
        folder_.write("session.jsonl", R"({"session": 1, "size": [9, 9]})"
                                       "\n" +
                                           line_of(0, UiEvent(InputEvent(KeyReleased{key}))));
    const SessionFile session = read_session(path);
    ASSERT_EQ(session.entries.size(), 1U) << i;
    EXPECT_EQ(
        std::get<KeyReleased>(std::get<InputEvent>(std::get<UiEvent>(session.entries[0].event)))
            .key,
        key);
  }
}

TEST_F(Sessions, APictureOfTheEditorIsThatOfASessionOnTheSameFile) {
  replay(R"({"t": 1, "shot": "first"})");
  const Image picture = picture_of_editor(folder_ / "scene.json", {900, 600}, {});
  EXPECT_EQ(picture, shot("first"));
  EXPECT_GT(differing_pixels(picture,
                             picture_of_editor(folder_ / "scene.json", {900, 600}, Theme::light)),
            900 * 600 / 2);
}

TEST_F(Sessions, APictureOfTheEditorIsRefusedInOneSentence) {
  EXPECT_THROW(picture_of_editor(folder_ / "none.json", {900, 600}, {}), Error);
  EXPECT_THROW(picture_of_editor(folder_ / "scene.json", {63, 600}, {}), Error);
  EXPECT_THROW(picture_of_editor(folder_ / "scene.json", {900, 16385}, {}), Error);
}

}  // namespace
}  // namespace foldless::test
