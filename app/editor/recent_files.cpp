// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/recent_files.h"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <utility>

#include "core/error.h"
#include "core/files/atomic_file.h"
#include "core/files/small_file.h"

namespace foldless {
namespace {

constexpr std::size_t kMost = 10;

std::vector<std::filesystem::path> read_list(const std::filesystem::path& file) {
  std::vector<std::filesystem::path> paths;
  const auto json =
      nlohmann::json::parse(read_small_file(file), nullptr, /*allow_exceptions=*/false);
  if (!json.is_array()) return paths;
  for (const auto& entry : json)
    if (entry.is_string() && paths.size() < kMost) paths.emplace_back(entry.get<std::string>());
  return paths;
}

}  // namespace

RecentFiles::RecentFiles(std::filesystem::path file) : file_(std::move(file)) {
  if (!file_.empty()) paths_ = read_list(file_);
}

void RecentFiles::add(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::path absolute = std::filesystem::absolute(path, error);
  const std::filesystem::path entry = (error ? path : absolute).lexically_normal();
  std::erase(paths_, entry);
  paths_.insert(paths_.begin(), entry);
  if (paths_.size() > kMost) paths_.resize(kMost);
  write();
}

void RecentFiles::remove(const std::filesystem::path& path) {
  std::erase(paths_, path);
  write();
}

void RecentFiles::write() const {
  if (file_.empty()) return;
  auto json = nlohmann::json::array();
  for (const auto& path : paths_) json.push_back(path.string());
  std::error_code error;
  std::filesystem::create_directories(file_.parent_path(), error);
  try {
    write_file_atomically(
        file_, json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  } catch (const Error&) {
    // Nothing of the user's is lost: the list stays in memory and is written with the next file.
  }
}

std::filesystem::path default_state_folder() {
  if (const char* state = std::getenv("XDG_STATE_HOME"); state && *state == '/')
    return std::filesystem::path(state) / "foldless";
  if (const char* home = std::getenv("HOME"); home && *home == '/')
    return std::filesystem::path(home) / ".local/state/foldless";
  return {};
}

}  // namespace foldless
