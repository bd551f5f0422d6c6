// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of the whole editor, drawn off screen: editor_pictures FOLDER [IMAGE]
// With an image, only those of its way to a pose.
// They are for looking at after a change; those of docs/images are of screen_pictures.cpp.
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>

#include "app/gui/samples.h"
#include "core/data_path.h"
#include "tests/app/gui/folding_document.h"
#include "tests/app/gui/headless_editor.h"
#include "tests/app/gui/time_line_pictures.h"
#include "tests/support/pictures.h"

namespace foldless::test {
namespace {

/// Where the rightmost handle is in the window: a hand of the figure on the first screen.
Vec2 right_hand(HeadlessEditor& headless) {
  Vec2 rightmost(-1, 0);
  for (const Handle& handle : headless.editor().document().handles) {
    const Vec2 point = headless.window_point(headless.position(handle.vertex));
    if (point.x() > rightmost.x()) rightmost = point;
  }
  return rightmost;
}

/// Pulls a handle and does not let go.
void begin_drag(HeadlessEditor& headless, const Vec2& from, const Vec2& by) {
  headless.press(from);
  headless.move(from + by / 2);
  headless.move(from + by);
}

void end_drag(HeadlessEditor& headless, const Vec2& at) {
  headless.release(at);
  headless.wait_until([&] { return !headless.editor().playback().is_solving(); }, 20);
  headless.calm_down();
}

/// Every dialog over a document that is open.
void draw_dialogs(HeadlessEditor& headless, const std::filesystem::path& folder) {
  const auto shoot = [&](const char* name) { save_png(folder / name, headless.picture()); };
  headless.key(Key::f1);
  shoot("cheat-sheet.png");
  headless.key(Key::escape);
  headless.key(Key::k, kControl);
  headless.type("fit");
  shoot("search.png");
  headless.key(Key::escape);
  headless.key(Key::o, kControl);
  shoot("file-browser.png");
  headless.key(Key::escape);
  headless.key(Key::e, kControl);
  shoot("export.png");
  headless.key(Key::escape);
  headless.click({20, 14});
  shoot("menu.png");
  headless.key(Key::escape);
  headless.click({640, 400});
  headless.editor().files().close();
  headless.settle();
  shoot("unsaved.png");
  headless.key(Key::escape);
}

void draw_all(const std::filesystem::path& folder) {
  HeadlessEditor headless;
  const auto shoot = [&](const char* name) {
    headless.settle();
    save_png(folder / name, headless.picture());
  };
  shoot("empty.png");
  headless.editor().files().open_sample(welcome_scene());
  headless.settle();
  headless.wait_until([&] { return !headless.editor().playback().is_solving(); }, 20);
  shoot("start.png");
  const Vec2 by{-60, -170};
  const Vec2 from = right_hand(headless);
  headless.editor().playback().set_pace(4);
  begin_drag(headless, from, by);
  headless.wait_until([&] { return headless.editor().playback().iterations().size() >= 2; }, 5);
  shoot("drag.png");
  headless.editor().playback().set_pace(std::nullopt);
  end_drag(headless, from + by);
  shoot("bent.png");
  headless.editor().view().options().layers.heat = true;
  headless.move(from + by * 0.5);
  shoot("heat.png");
  headless.ui().settings().theme = Theme::light;
  shoot("heat-light.png");
  headless.editor().view().options().layers.heat = false;
  shoot("light.png");
  headless.ui().settings().theme = Theme::contrast;
  shoot("contrast.png");
  headless.ui().settings().theme = Theme::dark;
  headless.ui().settings().scale = 2;
  shoot("narrow-200.png");
  headless.ui().settings().scale = 1;
  draw_dialogs(headless, folder);
}

/// Rest and deformed mesh side by side, and a race, of a sample in every theme.
void draw_comparisons(const std::filesystem::path& folder) {
  HeadlessEditor headless;
  const auto shoot = [&](const std::string& name) {
    headless.settle();
    save_png(folder / name, headless.picture());
  };
  headless.editor().files().open_sample(data_path("assets/scenes/figure3_flipped_edges.json"));
  headless.settle();
  headless.editor().playback().toggle_pause();
  headless.wait_until([&] { return !headless.editor().playback().is_solving(); }, 20);
  const Theme themes[] = {Theme::dark, Theme::light, Theme::contrast};
  const char* names[] = {"dark", "light", "contrast"};
  for (std::size_t i = 0; i < 3; ++i) {
    headless.ui().settings().theme = themes[i];
    headless.key(Key::d);
    const Rectangle& rest = headless.ui().layout().side;
    headless.move({rest.x + rest.width * 0.7, rest.y + rest.height * 0.5});
    shoot(std::string("diff-") + names[i] + ".png");
    headless.key(Key::d);
    headless.editor().view().options().layers.heat = i == 0;
    headless.key(Key::m);
    headless.wait_until([&] { return headless.editor().race().is_finished(); }, 20);
    headless.move({200, 600});
    shoot(std::string("race-") + names[i] + ".png");
    headless.key(Key::m);
  }
  headless.ui().settings().scale = 2;
  headless.key(Key::d);
  shoot("diff-narrow-200.png");
  headless.key(Key::d);
  headless.key(Key::m);
  headless.wait_until([&] { return headless.editor().race().is_finished(); }, 20);
  shoot("race-narrow-200.png");
}

/// What methods that may fold show and say.
void draw_folded(const std::filesystem::path& folder) {
  HeadlessEditor headless;
  Editor& editor = headless.editor();
  open_folding_disk(headless, "injective-projection");
  for (const char* name : {"folded-1.png", "folded-2.png"}) {
    const std::size_t done = editor.playback().iterations().size();
    editor.playback().step_forward();
    headless.wait_until([&] { return editor.playback().iterations().size() > done; }, 20);
    headless.calm_down();
    save_png(folder / name, headless.picture());
  }
  headless.ui().settings().theme = Theme::light;
  editor.playback().toggle_pause();
  headless.wait_until([&] { return !editor.playback().is_solving(); }, 20);
  headless.calm_down();
  save_png(folder / "unfolded-light.png", headless.picture());
  editor.edits().set_method("bounded-conformal");
  editor.edits().set_parameter(*find_parameter_row("start"), 0);
  headless.wait_until([&] { return !editor.playback().is_solving(); }, 20);
  headless.settle();
  save_png(folder / "infeasible-light.png", headless.picture());
}

/// A handle that cannot get through, and what the editor says to it.
void draw_stuck(const std::filesystem::path& folder) {
  HeadlessEditor headless;
  headless.editor().files().open_sample(data_path("assets/scenes/figure1_blocked_edge.json"));
  Document document = start_of_race(headless.editor().document(), true);
  document.parameters.method = "paper-noflip";
  headless.editor().draft().begin_edit();
  headless.editor().draft().apply(document, Change::mesh);
  headless.editor().draft().commit("Without flips");
  headless.wait_until([&] { return headless.editor().stuck().handle() != nullptr; }, 20);
  headless.calm_down();
  save_png(folder / "stuck-dark.png", headless.picture());
  headless.ui().settings().theme = Theme::light;
  headless.ui().settings().scale = 2;
  headless.settle();
  save_png(folder / "stuck-light-200.png", headless.picture());
  headless.ui().settings().scale = 1;
  headless.settle();
  headless.key(Key::f, {.shift = true});
  headless.wait_until([&] { return !headless.editor().playback().is_solving(); }, 20);
  headless.calm_down();
  save_png(folder / "stuck-flipped.png", headless.picture());
}

/// An image on its way to a pose: the dialog, the picture alone, a pulled pin, the mesh.
void draw_import(const std::filesystem::path& image, const std::filesystem::path& folder) {
  HeadlessEditor headless;
  Editor& editor = headless.editor();
  const auto shoot = [&](const char* name) { save_png(folder / name, headless.picture()); };
  editor.files().open(image);
  headless.settle();
  shoot("import-reading.png");
  headless.wait_until([&] { return editor.files().image_import().is_ready(); }, 20);
  shoot("import.png");
  headless.ui().settings().theme = Theme::light;
  headless.settle();
  shoot("import-light.png");
  headless.ui().settings().theme = Theme::dark;
  headless.ui().settings().scale = 2;
  headless.settle();
  shoot("import-200.png");
  headless.ui().settings().scale = 1;
  headless.settle();
  headless.key(Key::enter);
  headless.wait_until([&] { return !editor.document().is_empty(); }, 20);
  headless.calm_down();
  shoot("import-taken.png");
  const Points& rest = *editor.shown()->rest;
  Eigen::Index left = 0, right = 0;
  rest.row(0).minCoeff(&left);
  rest.row(0).maxCoeff(&right);
  headless.click(headless.window_point(rest.col(left)));
  const Vec2 from = headless.window_point(headless.position(static_cast<int>(right)));
  begin_drag(headless, from, {60, -90});
  end_drag(headless, from + Vec2(60, -90));
  shoot("import-posed.png");
  headless.key(Key::tab);
  headless.calm_down();
  shoot("import-mesh.png");
}

void draw_generated_import(const std::filesystem::path& folder) {
  const auto image = folder / "ring.png";
  write_ring(image, 600);
  draw_import(image, folder);
}

void draw_hidpi(const std::filesystem::path& folder) {
  HeadlessEditor headless({2560, 1600});
  headless.set_content_scale(2);
  headless.settle();
  headless.editor().files().open_sample(welcome_scene());
  headless.settle();
  headless.wait_until([&] { return !headless.editor().playback().is_solving(); }, 20);
  headless.settle();
  save_png(folder / "scale-200.png", headless.picture());
}

}  // namespace
}  // namespace foldless::test

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    std::cerr << "usage: editor_pictures FOLDER [IMAGE]\n";
    return EXIT_FAILURE;
  }
  try {
    std::filesystem::create_directories(argv[1]);
    if (argc == 3) {
      foldless::test::draw_import(argv[2], argv[1]);
      return EXIT_SUCCESS;
    }
    foldless::test::draw_time_line(argv[1]);
    foldless::test::draw_generated_import(argv[1]);
    foldless::test::draw_all(argv[1]);
    foldless::test::draw_hidpi(argv[1]);
    foldless::test::draw_comparisons(argv[1]);
    foldless::test::draw_stuck(argv[1]);
    foldless::test::draw_folded(argv[1]);
  } catch (const std::exception& error) {
    std::cerr << "editor_pictures: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
