// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/file_export.h"

#include <exception>
#include <utility>

#include "core/error.h"
#include "core/exception_words.h"

namespace foldless {

void FileExport::expect_idle() const {
  if (is_busy_) throw Error(path_.string() + " is still being written; wait until it is there.");
}

void FileExport::start(const std::filesystem::path& path, Write write,
                       const FileBrowser* asks_again) {
  expect_idle();
  is_busy_ = true;
  asks_again_ = asks_again != nullptr;
  asked_ = asks_again ? asks_again->asked() : 0;
  is_cancelled_ = false;
  path_ = path;
  // Who leaves at once wants the file too: only cancel() stops it.
  job_.start([this, write = std::move(write)](const std::stop_token&) {
    End end = end_of(write);
    const std::lock_guard lock(mutex_);
    end_ = std::move(end);
  });
}

FileExport::End FileExport::end_of(const Write& write) const {
  try {
    return {write(is_cancelled_), ""};
  } catch (const std::exception& error) {
    return {false, words_of_exception(error, path_)};
  }
}

/// Nobody is asked in the middle of a drag or of another question.
void FileExport::update(Editor& editor, FileBrowser& browser) {
  std::optional<End> end;
  {
    const std::lock_guard lock(mutex_);
    end = std::exchange(end_, {});
  }
  if (!end) return;
  is_busy_ = false;
  const bool can_ask = asks_again_ && browser.asked() == asked_ && !editor.draft().is_editing();
  if (end->is_written)
    editor.messages().toast(ToastKind::notice, "Wrote " + path_.string());
  else if (end->problem.empty())
    editor.messages().toast(ToastKind::notice, "The export was cancelled; nothing was written.");
  else if (can_ask)
    browser.ask_again(end->problem);
  else
    editor.messages().toast(ToastKind::error, end->problem);
}

}  // namespace foldless
