// SPDX-License-Identifier: GPL-3.0-or-later
#include <exception>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <utility>

#include "app/editor/document_files.h"
#include "core/exception_words.h"

namespace foldless {

UnsavedWork DocumentFiles::unsaved_work() const {
  const Document& document = draft_.document();
  return {document,
          {path(), document.name},
          std::make_shared<const nlohmann::json>(view_.json()),
          draft_.history().current_id()};
}

void DocumentFiles::update_autosave() {
  if (const std::string problem = autosave_.take_problem(); !problem.empty())
    messages_.toast(ToastKind::error,
                    "No copy of unsaved work could be kept, so save it yourself: " + problem);
  if (const std::string unseen = recovery_.take_unseen(); !unseen.empty())
    messages_.toast(ToastKind::error,
                    "There may be more unsaved work to recover, which is kept: " + unseen);
  if (recovery_.poll()) messages_.redraw();
  const bool is_unsaved = is_dirty() && !draft_.document().is_empty();
  if (autosave_.is_due(messages_.now(), is_unsaved ? &draft_.document() : nullptr,
                       draft_.history().current_id()))
    autosave_.begin(unsaved_work());
}

std::string DocumentFiles::rescue() {
  try {
    const bool is_unsaved = is_dirty() && !draft_.document().is_empty();
    return is_unsaved ? autosave_.write_now(unsaved_work()) : std::string();
  } catch (const std::exception& failure) {
    return words_of_exception(failure);
  }
}

void DocumentFiles::recover() { ask_or_perform({PendingKind::recover, {}}); }

void DocumentFiles::open_recovered() {
  if (!recovery_.is_open() || !recovery_.work()) return;
  const std::shared_ptr<const RecoveredWork> work = recovery_.work();
  const Origin origin = recovery_.origin(recovery_.selected());
  const std::string unread = recovery_.unread();
  const std::size_t others = recovery_.count() - 1;
  if (const auto image = recovery_.texture_image().image())
    texture_image_.adopt(work->document.texture, work->document.parts, image,
                         recovery_.texture_image().stamp());
  AutosaveFolder folder = recovery_.take();
  // What another program saved after the copy was made is not replaced without a question.
  std::optional<FileStamp> stamp = stamp_of(origin.path);
  const std::optional<FileStamp> copy = stamp_of(work->copy);
  std::error_code ignored;
  const std::string time = time_words(std::filesystem::last_write_time(work->copy, ignored));
  if (stamp && copy && stamp->time >= copy->time) stamp.reset();
  install(work->document, "Recover " + origin.name);
  if (work->view) view_.read(*work->view);
  take_file(origin.path, stamp);
  saved_step_ = kNeverSaved;
  // What could not be read is nobody's to remove: the folder stays for the next time.
  if (unread.empty())
    autosave_.adopt(std::move(folder));
  else
    messages_.toast(ToastKind::error,
                    "Newer work may be kept beside what was recovered, and is offered again the "
                    "next time: " +
                        unread);
  messages_.toast(ToastKind::notice, "Recovered as of " + time + "; it is not saved yet");
  if (others > 0) messages_.toast(ToastKind::notice, "More is kept: File, Recover unsaved work");
}

}  // namespace foldless
