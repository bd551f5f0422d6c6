// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of docs/images, drawn off screen: screen_pictures FOLDER
// Every screen in every theme at 100 % and 200 %, as SCREEN-THEME-PERCENT.webp.
#include <webp/encode.h>

#include <array>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <string>

#include "app/gui/samples.h"
#include "core/data_path.h"
#include "core/error.h"
#include "core/files/atomic_file.h"
#include "render/figure.h"
#include "tests/app/gui/headless_editor.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

namespace fs = std::filesystem;

/// How all screens look.
struct Appearance {
  Theme theme;
  int percent;
  std::string name;
  Extent window;
};

void save_webp(const fs::path& file, const Image& picture) {
  constexpr float kQuality = 80;
  std::uint8_t* bytes = nullptr;
  const std::size_t size = WebPEncodeRGBA(picture.pixels.data(), picture.width, picture.height,
                                          4 * picture.width, kQuality, &bytes);
  if (size == 0) throw Error(file.string() + ": WebP refuses the picture");
  const std::string text(reinterpret_cast<const char*>(bytes), size);
  WebPFree(bytes);
  write_file_atomically(file, text);
}

void open_sample(HeadlessEditor& headless, const fs::path& file) {
  headless.editor().files().open_sample(file);
  headless.settle();
  headless.wait_until([&] { return !headless.editor().playback().is_solving(); });
}

/// The handle that lies furthest to the right goes by that many pixels of the window.
void drag(HeadlessEditor& headless, const Vec2& by) {
  Vec2 hand(-1, 0);
  for (const Handle& handle : headless.editor().document().handles) {
    const Vec2 point = headless.window_point(headless.position(handle.vertex));
    if (point.x() > hand.x()) hand = point;
  }
  headless.press(hand);
  headless.move(hand + by / 2);
  headless.move(hand + by);
  headless.release(hand + by);
  headless.wait_until([&] { return !headless.editor().playback().is_solving(); });
}

/// A drawing of our own: the figure of the first sample, in checks, without a ground.
fs::path drawing(const TemporaryFolder& folder) {
  HeadlessEditor headless;
  open_sample(headless, welcome_scene());
  FigureOptions options;
  options.width = options.height = 700;
  options.style.layers = {.fill = true, .wireframe = false, .boundary = true, .handles = false};
  options.style.background = Background::transparent;
  save_png(folder / "figure.png", render_figure(*headless.editor().shown(), options));
  return folder / "figure.png";
}

/// Work that nobody saved, in the state folder of the editor that follows.
void lose_work(const EditorOptions& options) {
  HeadlessEditor headless({1200, 750}, {}, options);
  open_sample(headless, welcome_scene());
  drag(headless, {-40, -120});
  headless.editor().files().rescue();
}

class Screens {
 public:
  Screens(fs::path folder, Appearance appearance)
      : folder_(std::move(folder)), appearance_(std::move(appearance)) {}

  void draw(const fs::path& picture) {
    shoot("start", [](HeadlessEditor& headless) {
      headless.wait_until([&] { return !headless.next_frame(); });  // for the thumbnails
    });
    shoot("animate", [](HeadlessEditor& headless) {
      open_sample(headless, welcome_scene());
      headless.ui().settings().workspace = Workspace::animate;
      headless.settle();
      drag(headless, {-40, -120});
    });
    shoot("lab", [](HeadlessEditor& headless) {
      open_sample(headless, data_path("assets/scenes/figure3_flipped_edges.json"));
      headless.ui().settings().workspace = Workspace::lab;
      headless.editor().view().options().layers.heat = true;
      headless.editor().playback().toggle_pause();
      headless.wait_until([&] { return !headless.editor().playback().is_solving(); });
    });
    shoot("race", [](HeadlessEditor& headless) {
      open_sample(headless, data_path("assets/scenes/figure5_coarse_disk.json"));
      headless.editor().run_command("race.toggle");
      headless.settle();
      headless.editor().race().set_setup(energy_race(headless.editor().document()));
      headless.wait_until([&] { return headless.editor().race().is_finished(); });
    });
    shoot("export", [](HeadlessEditor& headless) {
      open_sample(headless, welcome_scene());
      headless.editor().run_command("file.export");
    });
    shoot("image", [&](HeadlessEditor& headless) {
      headless.editor().files().open(picture);
      headless.wait_until([&] { return headless.editor().files().image_import().is_ready(); });
    });
    shoot("recovery", [](HeadlessEditor& headless) {
      headless.editor().files().recovery().find();
      headless.wait_until([&] { return headless.editor().files().recovery().work() != nullptr; });
    });
  }

 private:
  void shoot(const std::string& screen, const std::function<void(HeadlessEditor&)>& prepare) {
    const TemporaryFolder state;
    const EditorOptions options{.state_folder = state.path(), .wake = {}};
    if (screen == "recovery") lose_work(options);
    HeadlessEditor headless(appearance_.window, {}, options);
    headless.set_content_scale(static_cast<float>(appearance_.percent) / 100);
    headless.ui().settings().theme = appearance_.theme;
    headless.settle();
    prepare(headless);
    headless.calm_down();
    const std::string name =
        screen + "-" + appearance_.name + "-" + std::to_string(appearance_.percent) + ".webp";
    save_webp(folder_ / name, headless.picture());
  }

  fs::path folder_;
  Appearance appearance_;
};

void draw_all(const fs::path& folder) {
  const TemporaryFolder drawings;
  const fs::path picture = drawing(drawings);
  for (const auto& [theme, name] :
       {std::pair(Theme::dark, "dark"), std::pair(Theme::light, "light"),
        std::pair(Theme::contrast, "contrast")}) {
    Screens(folder, {theme, 100, name, {1200, 750}}).draw(picture);
    Screens(folder, {theme, 200, name, {1800, 1125}}).draw(picture);
  }
}

}  // namespace
}  // namespace foldless::test

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: screen_pictures FOLDER\n";
    return EXIT_FAILURE;
  }
  try {
    std::filesystem::create_directories(argv[1]);
    foldless::test::draw_all(argv[1]);
  } catch (const std::exception& error) {
    std::cerr << "screen_pictures: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
