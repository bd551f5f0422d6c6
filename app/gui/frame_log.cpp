// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/frame_log.h"

#include "core/error.h"

namespace foldless {

FrameLog::FrameLog(const std::filesystem::path& file) {
  if (file.empty()) return;
  out_.open(file);
  if (!out_) throw Error(file.string() + ": the frame log cannot be written there.");
  out_ << "start_s,work_ms,shown_ms,editing,iterations\n";
}

void FrameLog::add(const FrameTimes& times) {
  if (!out_.is_open()) return;
  out_ << times.start << ',' << times.work * 1e3 << ',' << times.shown * 1e3 << ','
       << times.is_editing << ',' << times.iterations << '\n'
       << std::flush;
}

}  // namespace foldless
