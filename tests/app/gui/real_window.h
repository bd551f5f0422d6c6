// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include "core/mesh/injective.h"
#include "core/scene/scene_io.h"
#include "tests/support/child.h"
#include "tests/support/patience.h"

namespace foldless::test {

using namespace std::chrono_literals;

inline bool is_installed(const std::string& program) {
  return std::system(("command -v " + program + " > /dev/null 2>&1").c_str()) == 0;
}

template <class Condition>
bool wait_for(Condition condition, std::chrono::seconds most = kPatience) {
  const auto end = std::chrono::steady_clock::now() + most;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(50ms);
  }
  return true;
}

inline std::string output_of(const std::string& command) {
  FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  pclose(pipe);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

class RealWindow : public testing::Test {
 protected:
  void SetUp() override {
    if (!is_installed("Xvfb") || !is_installed("xdotool"))
      GTEST_SKIP() << "needs Xvfb and xdotool (packages xvfb and xdotool)";
    std::string name = (std::filesystem::temp_directory_path() / "foldless-x-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
    start_display();
    setenv("XDG_STATE_HOME", folder_.c_str(), 1);
    // The dialogs of whose desktop this is would wait for a person.
    setenv("DBUS_SESSION_BUS_ADDRESS", "disabled:", 1);
    // The X server's OpenGL driver is unloaded before leaks are looked for, so its own can neither
    // be named nor suppressed. The same interface is searched for leaks off screen.
    setenv("ASAN_OPTIONS", "detect_leaks=0", 1);
    setenv("FOLDLESS_FRAME_LOG", (folder_ / "frames.csv").c_str(), 1);
    scene_ = folder_ / "bar.json";
    write_scene();
  }
  void TearDown() override {
    program_.reset();
    if (!folder_.empty()) std::filesystem::remove_all(folder_);
  }

  /// Xvfb chooses a free display and tells which. It must not reset: without -noreset it begins
  /// anew whenever its last client leaves, and a client that comes just then is turned away.
  void start_display() {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    server_ = std::make_unique<Child>(std::vector<std::string>{
        "Xvfb", "-displayfd", std::to_string(ends[1]), "-noreset", "-screen", "0", "1280x800x24"});
    close(ends[1]);
    std::string number;
    for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';) number += c;
    close(ends[0]);
    ASSERT_FALSE(number.empty()) << "Xvfb did not start";
    setenv("DISPLAY", (":" + number).c_str(), 1);
  }

  /// A bar that is held at its left end and fills the middle of the canvas.
  void write_scene() {
    nlohmann::json vertices = nlohmann::json::array(), triangles = nlohmann::json::array();
    constexpr int kColumns = 12, kRows = 6;
    for (int j = 0; j <= kRows; ++j)
      for (int i = 0; i <= kColumns; ++i) vertices.push_back({i, j});
    for (int j = 0; j < kRows; ++j)
      for (int i = 0; i < kColumns; ++i) {
        const int a = j * (kColumns + 1) + i, b = a + kColumns + 1;
        triangles.push_back({a, a + 1, b + 1});
        triangles.push_back({a, b + 1, b});
      }
    const nlohmann::json scene{{"version", 1},
                               {"mesh", {{"vertices", vertices}, {"triangles", triangles}}},
                               {"energy", "arap"},
                               {"handles",
                                {{{"vertex", 0}, {"target", {0, 0}}},
                                 {{"vertex", kRows * (kColumns + 1)}, {"target", {0, kRows}}}}}};
    std::ofstream(scene_) << scene;
  }

  void start_program(const std::vector<std::string>& options = {}) {
    std::vector<std::string> words{FOLDLESS_PROGRAM, scene_.string()};
    words.insert(words.end(), options.begin(), options.end());
    program_ = std::make_unique<Child>(words);
    ASSERT_TRUE(wait_for([this] {
      window_ = output_of("xdotool search --onlyvisible --class foldless 2>/dev/null | head -n 1");
      return !window_.empty();
    })) << "no window appeared";
    tool("mousemove --window " + window_ + " 500 60");
    ASSERT_TRUE(comes_to_rest());
  }

  /// The lines of the frame log: one a frame, and its heading.
  std::ptrdiff_t logged_frames() const {
    std::ifstream log(folder_ / "frames.csv");
    return std::count(std::istreambuf_iterator<char>(log), {}, '\n');
  }
  /// Waits until the program draws no more: nothing moves and nothing is solved. One that only
  /// waits for a processor draws no more either.
  bool comes_to_rest() const {
    std::ptrdiff_t before = 0;
    int quiet = 0;
    return wait_for([&] {
      const std::ptrdiff_t now = logged_frames();
      quiet = now == before && now > 1 && all_sleep() ? quiet + 1 : 0;
      before = now;
      return quiet >= 20;
    });
  }
  /// Whether the program and the display wait for something to happen.
  bool all_sleep() const {
    for (const Child* child : {program_.get(), server_.get()}) {
      const std::string tasks = "/proc/" + std::to_string(child->pid()) + "/task";
      std::error_code gone;
      for (const auto& task : std::filesystem::directory_iterator(tasks, gone)) {
        std::ifstream file(task.path() / "stat");
        const std::string words{std::istreambuf_iterator<char>(file), {}};
        const std::size_t state = words.rfind(')') + 2;
        if (state < words.size() && words[state] != 'S') return false;
      }
    }
    return true;
  }

  void tool(const std::string& words) {
    ASSERT_EQ(std::system(("xdotool " + words).c_str()), 0) << words;
  }
  /// Moves the pointer in small steps, as a hand does.
  void drag(int x, int y, int dx, int dy) {
    constexpr int kSteps = 10;
    tool(move_to(x, y) + " sleep 0.2 mousedown 1");
    for (int i = 1; i <= kSteps; ++i)
      tool("sleep 0.05 " + move_to(x + dx * i / kSteps, y + dy * i / kSteps));
    tool("sleep 0.2 mouseup 1");
  }
  static std::string move_to(int x, int y) {
    std::ostringstream words;
    words << "mousemove " << x << " " << y;
    return words.str();
  }

  /// The newest copy of unsaved work, or empty. The program may remove one meanwhile.
  std::filesystem::path copy() const {
    using Files = std::filesystem::directory_iterator;
    std::filesystem::path newest;
    std::error_code gone;
    for (const auto& folder : Files(folder_ / "foldless/autosave", gone))
      for (const auto& entry : Files(folder, gone))
        if (entry.path().filename().string().starts_with("0"))
          newest = std::max(newest, entry.path());
    return newest;
  }
  void expect_copy_of_the_drag() const {
    ASSERT_FALSE(copy().empty()) << "the work is lost";
    const std::vector<std::string_view> methods{"foldless", "paper-flip"};
    EXPECT_EQ(load_scene(copy(), methods).scene.handles.size(), 3U);
  }

  std::filesystem::path folder_;
  std::filesystem::path scene_;
  std::unique_ptr<Child> server_;
  std::unique_ptr<Child> program_;
  std::string window_;
};

}  // namespace foldless::test
