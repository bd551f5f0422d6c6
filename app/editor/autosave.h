// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "app/editor/autosave_folder.h"
#include "app/editor/document.h"
#include "core/run/latest_job.h"

namespace foldless {

/// Work that is not saved, as it is now.
struct UnsavedWork {
  Document document;
  Origin origin;
  std::shared_ptr<const nlohmann::json> view;
  std::uint64_t step = 0;  ///< of the history
};

/// Keeps copies of unsaved work on disk, for when the program ends without being asked to; writes
/// them on a thread of its own.
class Autosave {
 public:
  static constexpr double kShortestInterval = 15, kLongestInterval = 3600;  ///< [s]

  /// Copies go to folders in `root`; empty: none are made. `wake` is called on that thread when a
  /// copy was written or could not be.
  explicit Autosave(std::filesystem::path root, std::function<void()> wake = {});

  /// How long a change may wait for its copy. [s]
  void set_interval(double seconds) { interval_ = seconds; }

  /// Whether it is time for a copy by the editor's clock: unsaved work has changed since the last
  /// one, an interval ago. `document` null: nothing is unsaved. Call it in every frame.
  bool is_due(double now, const Document* document, std::uint64_t step);
  /// When is_due() may become true, if ever. [s]
  std::optional<double> next_wake() const { return due_; }
  /// Begins to write a copy.
  void begin(UnsavedWork work);
  /// Writes one before it returns. Returns why that cannot be done, empty when it can. Never
  /// throws.
  std::string write_now(const UnsavedWork& work);
  /// The work is saved, or is not wanted: removes its copies, after one that is being written.
  void forget();
  /// Goes on in a folder with copies of the present work.
  void adopt(AutosaveFolder folder);
  /// Why a copy could not be written, once in a row of failures; empty: nothing new. One that
  /// failed is tried again after the interval.
  std::string take_problem();

 private:
  struct Mark {
    std::shared_ptr<const Snapshot> pose;
    std::vector<Handle> handles;
    std::uint64_t step = 0;
  };

  /// Returns why it cannot.
  std::string write(const UnsavedWork& work, std::uint64_t generation);
  void report(std::string problem);

  std::filesystem::path root_;
  std::function<void()> wake_;
  double interval_ = 60;
  std::optional<Mark> copied_;  ///< what the newest copy has
  std::optional<double> due_;

  std::atomic<std::uint64_t> generation_ = 0;  ///< copies of an earlier one are not wanted any more

  std::mutex folder_mutex_;  ///< of what follows; held while a copy is written
  std::optional<AutosaveFolder> folder_;
  std::optional<Origin> origin_;  ///< that the folder has

  std::mutex news_mutex_;  ///< of what follows
  std::string problem_;
  bool has_failed_ = false;     ///< since the last success
  bool wants_another_ = false;  ///< the newest copy failed

  LatestJob job_;  ///< the last member: it ends before what it uses
};

}  // namespace foldless
