// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/editor/autosave_folder.h"
#include "app/editor/document.h"
#include "app/editor/texture_image.h"
#include "core/run/latest_job.h"

namespace foldless {

/// What a copy holds.
struct RecoveredWork {
  Document document;
  std::shared_ptr<const nlohmann::json> view;  ///< null: none
  std::filesystem::path copy;
};

/// Offers work that was lost when the program ended without being asked to: what there is, and the
/// one that is looked at, read on a thread of its own. Nobody else is offered it meanwhile.
class Recovery {
 public:
  /// `root` is where copies are kept; `wake` is called on that thread when poll() has news.
  Recovery(std::filesystem::path root, std::function<void()> wake);

  /// Looks for lost work; open if there is any.
  void find();
  /// Why there may be more than was found; one sentence, empty: there is not.
  const std::string& unseen() const { return unseen_; }
  std::string take_unseen() { return std::exchange(unseen_, {}); }
  /// Leaves it all where it is.
  void close();
  bool is_open() const { return !lost_.empty(); }
  bool poll();

  /// Newest first.
  std::size_t count() const { return lost_.size(); }
  Origin origin(std::size_t index) const { return lost_[index].origin; }
  /// When its newest copy was written, in words.
  std::string time(std::size_t index) const { return lost_[index].time; }

  /// The one that is looked at. Precondition of what follows: is_open().
  std::size_t selected() const { return selected_; }
  void select(std::size_t index);
  /// Null while it is read, and where it cannot be.
  const std::shared_ptr<const RecoveredWork>& work() const { return work_; }
  /// Why not one of its copies can be read; one sentence.
  const std::string& problem() const { return problem_; }
  /// Why there may be newer work beside it: what cannot be read; one sentence, empty: there is
  /// none.
  const std::string& unread() const { return unread_; }
  const TextureImage& texture_image() const { return texture_image_; }
  /// Removes its copies for good.
  void discard();
  /// Gives its folder away and closes.
  AutosaveFolder take();

 private:
  struct Lost {
    AutosaveFolder folder;
    std::vector<std::filesystem::path> copies;
    Origin origin;
    std::string time;
    std::string unread;  ///< why its origin is not known
  };
  struct News {
    int request = 0;
    std::shared_ptr<const RecoveredWork> work;
    std::string problem;
    std::string unread;
  };

  static Lost look_into(AutosaveFolder folder);
  void read(News news, const std::vector<std::filesystem::path>& copies, const Origin& origin);

  std::filesystem::path root_;
  std::function<void()> wake_;
  std::vector<Lost> lost_;
  std::size_t selected_ = 0;
  int request_ = 0;  ///< news of earlier ones are dropped
  std::shared_ptr<const RecoveredWork> work_;
  std::string problem_, unread_, unseen_;
  TextureImage texture_image_;
  std::mutex mutex_;  ///< of what follows
  std::optional<News> news_;
  LatestJob job_;  ///< the last member: it ends before what it uses
};

}  // namespace foldless
