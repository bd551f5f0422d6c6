// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/autosave_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/error.h"
#include "core/files/atomic_file.h"
#include "core/files/folder_names.h"
#include "core/files/small_file.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kCopies = 5;
constexpr const char* kLock = "lock";
constexpr const char* kOrigin = "origin.json";
constexpr const char* kNew = ".new-";  ///< begins the name of a folder that is being made
/// Another process may be about to lock a younger one.
constexpr std::chrono::hours kLeftOverAfter{1};

/// The number of a copy by its file name, `000012.json`.
std::optional<int> number_of(const fs::path& file) {
  const std::string name = file.filename().string();
  int number = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  if (error != std::errc{} || std::string_view(end) != ".json") return std::nullopt;
  return number;
}

/// A file that we write, or what is left of one whose writing was cut off.
bool is_ours(std::string name) {
  if (name.starts_with('.')) name = fs::path(name.substr(1)).stem().string();
  return name == kLock || name == kOrigin || number_of(name);
}

fs::path copy_named(int number) {
  std::array<char, 24> name{};
  std::snprintf(name.data(), name.size(), "%06d.json", number);
  return name.data();
}

/// An open lock file that is locked by us; -1 and errno where it cannot be.
int locked(const fs::path& file, int flags) {
  const int descriptor = open(file.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | flags, 0600);
  if (descriptor < 0) return -1;
  if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  const int error = errno;
  close(descriptor);
  errno = error;
  return -1;
}

/// Those of the names that are of copies, newest first.
std::vector<fs::path> copies_among(const std::vector<std::string>& names, const fs::path& folder) {
  std::vector<fs::path> copies;
  for (const std::string& name : names)
    if (number_of(name)) copies.push_back(folder / name);
  std::ranges::sort(copies, std::greater{}, number_of);
  return copies;
}

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
  throw Error(path.string() + ": cannot be written to: " + reason);
}

}  // namespace

AutosaveFolder AutosaveFolder::create(const fs::path& root) {
  std::error_code error;
  fs::create_directories(root, error);
  if (error) fail(root, error.message());
  // Not seen by find_lost_work() before it is locked.
  std::string hidden = (root / (kNew + std::string("XXXXXX"))).string();
  if (!mkdtemp(hidden.data())) fail(root, std::strerror(errno));
  AutosaveFolder folder(hidden, locked(fs::path(hidden) / kLock, O_CREAT));
  int failure = folder.lock_ < 0 ? errno : 0;
  const fs::path path = root / fs::path(hidden).filename().string().substr(std::strlen(kNew));
  if (failure == 0 && ::rename(hidden.c_str(), path.c_str()) != 0) failure = errno;
  if (failure != 0) {
    folder.remove();
    fail(root, std::strerror(failure));
  }
  sync_folder(root);
  folder.path_ = path;
  return folder;
}

std::optional<AutosaveFolder> AutosaveFolder::take(const fs::path& folder) {
  const int lock = locked(folder / kLock, 0);
  if (lock >= 0) return AutosaveFolder(folder, lock);
  if (errno == EWOULDBLOCK || errno == ENOENT || errno == ENOTDIR || errno == ELOOP)
    return std::nullopt;
  throw Error(folder.string() + ": cannot be looked into: " + std::strerror(errno));
}

AutosaveFolder::AutosaveFolder(AutosaveFolder&& other) noexcept
    : path_(std::move(other.path_)), lock_(std::exchange(other.lock_, -1)) {}

AutosaveFolder& AutosaveFolder::operator=(AutosaveFolder&& other) noexcept {
  if (this == &other) return *this;
  release();
  path_ = std::move(other.path_);
  lock_ = std::exchange(other.lock_, -1);
  return *this;
}

AutosaveFolder::~AutosaveFolder() { release(); }

void AutosaveFolder::release() {
  if (lock_ >= 0) close(std::exchange(lock_, -1));
}

Origin AutosaveFolder::origin() const {
  const auto json = nlohmann::json::parse(small_file(path_ / kOrigin), nullptr, false);
  const auto text_of = [&](const char* key) -> std::string {
    if (!json.is_object() || !json.contains(key) || !json[key].is_string()) return {};
    return json[key].get<std::string>();
  };
  return {text_of("path"), text_of("name")};
}

std::vector<fs::path> AutosaveFolder::copies() const {
  return copies_among(all_names_in_folder(path_), path_);
}

fs::path AutosaveFolder::next_copy() const {
  const std::vector<fs::path> there = copies();
  return path_ / copy_named(there.empty() ? 1 : *number_of(there.front()) + 1);
}

void AutosaveFolder::set_origin(const Origin& origin) {
  const nlohmann::json json{{"path", origin.path.string()}, {"name", origin.name}};
  // A path may be no UTF-8.
  const auto replacing = nlohmann::json::error_handler_t::replace;
  write_file_atomically(path_ / kOrigin, json.dump(2, ' ', false, replacing) + "\n");
}

void AutosaveFolder::trim() {
  const std::vector<fs::path> there = copies_among(names_in_folder(path_), path_);
  std::error_code ignored;
  for (std::size_t i = kCopies; i < there.size(); ++i) fs::remove(there[i], ignored);
}

// Where the program is ended on the way, or a copy cannot be removed, the newest is left, for it is
// what the next start offers.
void AutosaveFolder::remove() {
  const std::vector<std::string> names = names_in_folder(path_);
  const std::vector<fs::path> copies = copies_among(names, path_);
  std::error_code ignored;
  for (std::size_t i = copies.size(); i-- > 0;) {
    fs::remove(copies[i], ignored);
    if (ignored) return release();
  }
  for (const std::string& name : names)
    if (is_ours(name) && name != kLock) fs::remove(path_ / name, ignored);
  fs::remove(path_ / kLock, ignored);
  fs::remove(path_, ignored);
  release();
}

namespace {

/// Removes what a process left that was ended while it made a folder.
void remove_left_over(const fs::path& hidden) {
  std::error_code error;
  const auto made = fs::last_write_time(hidden, error);
  if (error || fs::file_time_type::clock::now() - made < kLeftOverAfter) return;
  if (std::optional<AutosaveFolder> folder = AutosaveFolder::take(hidden))
    folder->remove();
  else
    rmdir(hidden.c_str());  // where it is an empty folder
}

}  // namespace

LostWork find_lost_work(const fs::path& root) {
  LostWork lost;
  std::vector<std::pair<fs::file_time_type, AutosaveFolder>> found;
  const auto look_at = [&](const fs::path& path) {
    std::optional<AutosaveFolder> folder = AutosaveFolder::take(path);
    if (!folder) return;
    const std::vector<fs::path> copies = folder->copies();
    std::error_code ignored;
    if (copies.empty())
      folder->remove();
    else
      found.emplace_back(fs::last_write_time(copies.front(), ignored), std::move(*folder));
  };
  const auto bear = [&](const auto& action) {
    try {
      action();
    } catch (const Error& error) {
      if (lost.problem.empty()) lost.problem = error.what();
    }
  };
  bear([&] {
    for (const std::string& name : all_names_in_folder(root)) {
      if (name.starts_with(kNew)) bear([&] { remove_left_over(root / name); });
      if (!name.starts_with('.')) bear([&] { look_at(root / name); });
    }
  });
  std::ranges::sort(found, std::greater{}, [](const auto& one) { return one.first; });
  for (auto& [time, folder] : found) lost.folders.push_back(std::move(folder));
  return lost;
}

std::string time_words(fs::file_time_type written) {
  const auto since = written - fs::file_time_type::clock::now();
  const auto moment = std::chrono::system_clock::now() +
                      std::chrono::duration_cast<std::chrono::system_clock::duration>(since);
  const std::time_t time = std::chrono::system_clock::to_time_t(moment);
  const std::time_t now = std::time(nullptr);
  std::tm then{}, today{}, yesterday{};
  localtime_r(&time, &then);
  localtime_r(&now, &today);
  yesterday = today;
  --yesterday.tm_mday;
  std::mktime(&yesterday);
  const auto is_on = [&](const std::tm& day) {
    return then.tm_year == day.tm_year && then.tm_yday == day.tm_yday;
  };
  const char* format = is_on(today)       ? "today %H:%M"
                       : is_on(yesterday) ? "yesterday %H:%M"
                                          : "%e %b %Y, %H:%M";
  std::array<char, 64> words{};
  std::strftime(words.data(), words.size(), format, &then);
  return words.data();
}

}  // namespace foldless
