// SPDX-License-Identifier: GPL-3.0-or-later
// What is left of a session that poses a drawing, saves and exports, and is killed at some moment.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <random>
#include <thread>

#include "app/editor/handle_edits.h"
#include "app/gui/sequence_export.h"
#include "core/files/atomic_file.h"
#include "core/files/mesh_io.h"
#include "core/mesh/injective.h"
#include "core/method/methods.h"
#include "core/scene/scene_io.h"
#include "tests/app/gui/headless_editor.h"
#include "tests/support/kept_work.h"
#include "tests/support/number_from.h"
#include "tests/support/pictures.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr const char* kFolder = "FOLDLESS_KILLED_SESSION";  // set for the program that is killed
constexpr Extent kWindow{700, 420};

// Every step leads to another pose, depth and view.

Vec2 target_at(int step) {
  const double radius = 2 + 0.005 * step, angle = 0.3 * step;
  return Vec2(20, 8) + radius * Vec2(std::cos(angle), std::sin(angle));
}
double depth_at(int step) { return step % 50; }
Camera camera_at(int step) { return {{20.0 + step % 10, 20}, 6}; }
std::string name_at(int step) { return "step " + std::to_string(step); }

/// Counts the steps that are done, where the other program sees it.
std::atomic<int>& counter_in(const fs::path& folder) {
  const int file = open((folder / "counter").c_str(), O_RDWR | O_CREAT, 0600);
  EXPECT_EQ(ftruncate(file, 4096), 0);
  void* shared = mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  close(file);
  EXPECT_NE(shared, MAP_FAILED);
  return *static_cast<std::atomic<int>*>(shared);
}

UiOptions ui_options(const fs::path& folder) {
  return {.state_folder = folder / "state", .pictures_folder = folder / "files"};
}

/// The session that is killed.
class Session {
 public:
  explicit Session(const fs::path& folder)
      : files_(folder / "files"),
        headless_(kWindow, ui_options(folder), {.state_folder = folder / "state", .wake = {}}) {
    headless_.ui().settings().autosave_seconds = 0.02;
    editor().files().open(files_ / "ring.png");
    headless_.wait_until([this] { return editor().files().image_import().is_ready(); });
    editor().files().take_image();
    headless_.calm_down();
    const Points& at = editor().shown()->deformed;
    Eigen::Index lowest = 0, highest = 0;
    at.row(1).minCoeff(&lowest);
    at.row(1).maxCoeff(&highest);
    for (const Eigen::Index vertex : {highest, lowest})
      headless_.click(headless_.window_point(headless_.position(static_cast<int>(vertex))));
  }

  void make_step(int step) {
    Editor& e = editor();
    const int id = e.document().handles.back().id;
    const Vec2 from = headless_.window_point(find_handle(e.document(), id)->target);
    headless_.press(from);
    headless_.move((from + headless_.window_point(target_at(step))) / 2);
    headless_.release(headless_.window_point(target_at(step)));
    e.selection().select({id});
    set_coordinate(e, 0, target_at(step).x());
    set_coordinate(e, 1, target_at(step).y());
    set_depth(e, depth_at(step));
    e.view().set_camera(camera_at(step));
    set_name(e, name_at(step));
    headless_.settle();
  }

  void write_something(int step) {
    const std::string number = std::to_string(step);
    switch (step % 8) {
      case 1: headless_.key(Key::f12); break;
      case 2: export_as(number + ".svg"); break;
      case 3: export_as(number + ".obj"); break;
      case 4: editor().files().save_as(files_ / "scene.json"); break;
      case 5: export_as(number + ".pdf"); break;
      case 6: begin_sequence("film " + number); break;
      default: break;
    }
    if (sequence_.is_busy()) sequence_.update(editor(), step);
  }

 private:
  Editor& editor() { return headless_.editor(); }
  void export_as(const std::string& name) {
    headless_.key(Key::e, kControl);
    headless_.key(Key::enter);
    headless_.key(Key::a, kControl);
    headless_.type((files_ / name).string());
    headless_.key(Key::enter);
  }
  void begin_sequence(const std::string& name) {
    headless_.wait_until([this] { return editor().playback().can_scrub(); }, 1);
    if (!sequence_.is_busy() && editor().playback().can_scrub())
      sequence_.start(files_ / name, editor(), {});
  }

  fs::path files_;
  HeadlessEditor headless_;
  SequenceExport sequence_;
};

/// Not a test: what the program that is killed runs.
TEST(KilledSession, DISABLED_Works) {
  const char* folder = std::getenv(kFolder);
  if (!folder) GTEST_SKIP() << "is run by the test below";
  Session session(folder);
  std::atomic<int>& done = counter_in(folder);
  for (int step = 1;; ++step) {
    session.make_step(step);
    done = step;
    session.write_something(step);
  }
}

pid_t start_session(const fs::path& folder) {
  const pid_t child = fork();
  if (child != 0) return child;
  setenv(kFolder, folder.c_str(), 1);
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  unsetenv("GTEST_TOTAL_SHARDS");
  unsetenv("GTEST_SHARD_INDEX");
  unsetenv("TEST_PREMATURE_EXIT_FILE");
  execl("/proc/self/exe", "gui_tests", "--gtest_filter=KilledSession.DISABLED_Works",
        "--gtest_also_run_disabled_tests", nullptr);
  _exit(127);
}

/// Every file is whole: what was cut off has another name, which begins with a dot.
void expect_whole_files(const fs::path& folder, int& count) {
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path file = entry.path();
    if (entry.is_directory() || file.filename().string().starts_with('.')) continue;
    SCOPED_TRACE(file);
    ++count;
    const std::string kind = file.extension();
    const auto ends = [&](const char* mark) {
      return read_file(file).find(mark) != std::string::npos;
    };
    EXPECT_TRUE(kind != ".png" || load_image(file).width > 0);
    EXPECT_TRUE(kind != ".obj" || read_mesh(file).points.cols() > 100);
    EXPECT_TRUE(kind != ".json" || load_scene(file, method_names()).scene.handles.size() == 2);
    EXPECT_TRUE(kind != ".svg" || ends("</svg>"));
    EXPECT_TRUE(kind != ".pdf" || ends("%%EOF"));
  }
}

/// The step that led to a document, all of which has to be of it or on the way to the next.
int step_of(const Editor& editor) {
  const Document& document = editor.document();
  if (document.handles.size() != 2) return -1;
  const Handle& handle = document.handles.back();
  const int step = std::atoi(handle.name.substr(handle.name.find(' ') + 1).c_str());
  const auto fits = [step](const auto& value, const auto& at) {
    return value == at(step) || value == at(step + 1);
  };
  EXPECT_TRUE(fits(handle.name, name_at)) << handle.name;
  EXPECT_TRUE(fits(handle.depth, depth_at)) << handle.depth;
  EXPECT_TRUE(fits(editor.canvas().camera, camera_at));
  EXPECT_EQ(document.texture.filename(), "ring.png");
  EXPECT_EQ(document.texture_box, (TextureBox{{0, 0}, {40, 40}}));
  EXPECT_TRUE(
      is_injective(*document.pose->triangles, *document.pose->rest, document.pose->deformed));
  return step;
}

class KilledSessions : public testing::Test {
 protected:
  /// Lets a session work for some time, until that is kept, and a little more, and ends it.
  void work_and_kill(std::chrono::milliseconds time) {
    std::atomic<int>& done = counter_in(folder_->path());
    const pid_t child = start_session(folder_->path());
    ASSERT_GT(child, 0);
    comes_true([&done] { return done > 0; });
    std::this_thread::sleep_for(time);
    steps_ = done;
    const bool is_kept = is_kept_anew(*folder_ / "state", *folder_ / "files/scene.json");
    std::this_thread::sleep_for(time / 3);
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    ASSERT_GT(steps_, 0) << "the session did not begin";
    ASSERT_TRUE(is_kept);
  }
  /// The newest step that is there, saved or recovered.
  int newest_step() {
    HeadlessEditor headless(kWindow, ui_options(folder_->path()),
                            {.state_folder = *folder_ / "state", .wake = {}});
    DocumentFiles& files = headless.editor().files();
    int newest = -1;
    if (fs::exists(*folder_ / "files/scene.json")) {
      files.open(*folder_ / "files/scene.json");
      newest = step_of(headless.editor());
    }
    files.recovery().find();
    if (!files.recovery().is_open()) return newest;
    EXPECT_TRUE(headless.wait_until([&] { return files.recovery().work() != nullptr; }))
        << files.recovery().problem();
    files.recover();
    files.answer(Answer::discard);
    return std::max(newest, step_of(headless.editor()));
  }

  std::unique_ptr<TemporaryFolder> folder_;
  int steps_ = 0;
};

/// FOLDLESS_KILLS says how often, FOLDLESS_SEED where the random moments begin.
TEST_F(KilledSessions, LeaveWholeFilesAndAllWorkButTheLastSteps) {
  const int killings = number_from("FOLDLESS_KILLS", 3);
  const auto seed = static_cast<unsigned>(number_from("FOLDLESS_SEED", 20261124));
  std::mt19937 random(seed);
  int files = 0;
  for (int round = 0; round < killings; ++round) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", round " + std::to_string(round));
    folder_ = std::make_unique<TemporaryFolder>();
    fs::create_directory(*folder_ / "files");
    write_ring(*folder_ / "files/ring.png", 40);
    work_and_kill(std::chrono::milliseconds(random() % 1500));
    expect_whole_files(*folder_ / "files", files);
    EXPECT_GE(newest_step(), steps_) << "it was copied";
    if (HasFailure()) break;
  }
  RecordProperty("files", files);
}

}  // namespace
}  // namespace foldless::test
