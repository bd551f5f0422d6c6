// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/figure_export.h"

#include <exception>
#include <utility>

#include "app/export/vector_figure.h"
#include "core/error.h"
#include "core/exception_words.h"

namespace foldless {

void FigureExport::start(const std::filesystem::path& path, const Editor& editor,
                         const PictureOptions& options) {
  if (is_busy_) throw Error(path_.string() + " is still being written; wait until it is there.");
  if (!editor.shown()) throw Error("There is no mesh to make a figure of: open one first.");
  is_busy_ = true;
  path_ = path;
  job_.start([this, path, snapshot = editor.shown(), figure = figure_of_canvas(editor, options),
              texts = picture_texts(editor)](const std::stop_token&) {
    std::string problem;
    try {
      save_vector_figure(path, *snapshot, figure, texts);
    } catch (const std::exception& error) {
      problem = words_of_exception(error, path);
    }
    const std::lock_guard lock(mutex_);
    problem_ = std::move(problem);
  });
}

void FigureExport::update(Editor& editor) {
  std::optional<std::string> problem;
  {
    const std::lock_guard lock(mutex_);
    problem = std::exchange(problem_, {});
  }
  if (!problem) return;
  is_busy_ = false;
  if (problem->empty())
    editor.messages().toast(ToastKind::notice, "Wrote " + path_.string());
  else
    editor.messages().toast(ToastKind::error, *problem);
}

}  // namespace foldless
