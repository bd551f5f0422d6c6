// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/result_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <exception>
#include <optional>
#include <system_error>
#include <utility>

#include "core/error.h"
#include "core/files/atomic_file.h"
#include "core/files/folder_names.h"
#include "core/threads/team.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStaged = ".foldless-staged";
constexpr const char* kCommitted = ".foldless-committed";
constexpr const char* kFrames = "frames";
/// In `.foldless-committed`: a folder with the frames of the earlier result.
constexpr const char* kEarlier = "earlier";

[[noreturn]] void refuse(const fs::path& path, const std::string& what) {
  throw Error(path.string() + ": " + what);
}

bool is_there(const fs::path& path) { return fs::exists(fs::symlink_status(path)); }
bool is_real_folder(const fs::path& path) { return fs::is_directory(fs::symlink_status(path)); }

/// Names of all files in a folder and in its `frames`, none of them reached by a symbolic link.
std::vector<std::string> names_below(const fs::path& folder) {
  std::vector<std::string> names;
  for (const fs::path part : {"", kFrames})
    if (is_real_folder(folder / part))
      for (const std::string& name : names_in_folder(folder / part))
        names.push_back((part / name).string());
  return names;
}

/// The name that a temporary file of write_file_atomically() is to take.
std::string without_temporary(const std::string& name) {
  const fs::path path = name;
  const std::string file = path.filename().string();
  if (!file.starts_with('.')) return name;
  return (path.parent_path() / file.substr(1, file.rfind('.') - 1)).string();
}

/// Removes what `solve` writes into `.foldless-staged` or `.foldless-committed`, and the folder
/// where nothing else is in it.
void remove_own(const fs::path& folder) {
  if (!is_real_folder(folder)) return;
  remove_own(folder / kEarlier);
  for (const std::string& name : names_below(folder))
    if (is_result_name(without_temporary(name))) ::unlink((folder / name).c_str());
  ::rmdir((folder / kFrames).c_str());
  ::rmdir(folder.c_str());
}

void rename_or_refuse(const fs::path& from, const fs::path& to) {
  std::error_code failure;
  fs::rename(from, to, failure);
  if (failure)
    refuse(to, "cannot be replaced: " + failure.message() + "; the new file is " + from.string());
}

bool names(const Manifest& manifest, const std::string& name) {
  return std::ranges::find(manifest, name, &ResultFile::name) != manifest.end();
}

bool is_frame(const std::string& name) { return fs::path(name).parent_path() == kFrames; }

}  // namespace

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

// A file system without locks is no reason to refuse: two runs in one folder are rare.
bool FolderLock::take(const fs::path& folder) {
  descriptor_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  return descriptor_ < 0 || ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

void make_folder(const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) refuse(folder, "cannot be made: " + failure.message());
  if (!fs::is_directory(folder)) refuse(folder, "is not a folder");
}

MadeFolder::MadeFolder(fs::path folder)
    : folder_(std::move(folder)), was_made_(!fs::exists(folder_)) {
  make_folder(folder_);
}

MadeFolder::~MadeFolder() {
  if (was_made_) ::rmdir(folder_.c_str());
}

fs::path newest_of_result(const fs::path& file) {
  const fs::path newer = file.parent_path() / kCommitted / file.filename();
  return fs::exists(newer) ? newer : file;
}

ResultFolder::ResultFolder(fs::path folder) : folder_(std::move(folder)), made_(folder_) {
  if (!lock_.take(folder_))
    refuse(folder_, "another run is writing into this folder; wait for it or choose another");
  earlier_ = read_manifest(folder_);
  if (is_real_folder(folder_ / kCommitted)) take_names();
  remove_own(staged());
  if (is_there(staged())) refuse(staged(), "has files that solve did not write; move them away");
  std::error_code failure;
  fs::create_directory(staged(), failure);
  if (failure) refuse(folder_, "cannot be written to: " + failure.message());
}

ResultFolder::~ResultFolder() {
  // What cannot be removed for want of memory the next run removes; once more, as some is freed.
  for (int tries = 0; tries < 2; ++tries) {
    try {
      remove_own(staged());
      return;
    } catch (const std::exception&) {
      continue;
    }
  }
}

fs::path ResultFolder::staged() const { return folder_ / kStaged; }

std::string ResultFolder::with_final_names(std::string message) const {
  const std::string internal = (staged() / "").string(), known = (folder_ / "").string();
  for (std::size_t at = 0; (at = message.find(internal, at)) != message.npos; at += known.size())
    message.replace(at, internal.size(), known);
  return message;
}

void ResultFolder::expect_free(const std::string& name) const {
  const fs::path file = folder_ / name;
  const fs::path frames = folder_ / kFrames;
  if (file.parent_path() == frames && is_there(frames) && !is_real_folder(frames))
    refuse(frames, "is not a folder; move it away or choose another folder for the result");
  if (!is_there(file)) return;
  if (!is_own(name))
    refuse(file, "is not as an earlier solve left it; move it away or choose another folder");
}

bool ResultFolder::is_own(const std::string& name) const {
  const auto entry = entry_of(folder_, name);
  return entry && std::ranges::find(earlier_, *entry) != earlier_.end();
}

void ResultFolder::expect_free_frames() const {
  expect_free("frames/000000.obj");
  for (const std::string& name : names_below(folder_))
    if (is_frame(name) && is_result_name(name)) expect_free(name);
}

void ResultFolder::commit() {
  const std::vector<std::string> files = names_below(staged());
  std::vector<std::optional<ResultFile>> entries(files.size());
  in_parallel(static_cast<int>(files.size()), [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    entries[at] = entry_of(staged(), files[at]);
  });
  Manifest manifest;
  for (const auto& entry : entries)
    if (entry) manifest.push_back(*entry);
  std::ranges::sort(manifest, {}, &ResultFile::name);
  for (const ResultFile& file : manifest) expect_free(file.name);
  write_new_file(staged() / kManifest, text_of(manifest), staged() / kManifest);
  sync_folder(staged());
  rename_or_refuse(staged(), folder_ / kCommitted);
  sync_folder(folder_);
  take_names();
}

// Where it was killed it begins again: what has taken its name already is not in `committed` any
// more, and what the earlier manifest names is removed while that manifest is still there.
void ResultFolder::take_names() {
  const fs::path committed = folder_ / kCommitted;
  if (is_there(committed / kManifest)) {
    const Manifest manifest = read_manifest(committed);
    Manifest arriving;
    for (const ResultFile& file : manifest)
      if (is_there(committed / file.name)) arriving.push_back(file);
    for (const ResultFile& file : arriving) expect_free(file.name);
    take_frames(manifest);
    // The two meshes right after each other: many readers look at nothing else.
    std::stable_partition(arriving.begin(), arriving.end(),
                          [](const ResultFile& file) { return !file.name.ends_with(".obj"); });
    for (const ResultFile& file : arriving)
      if (is_there(committed / file.name))
        rename_or_refuse(committed / file.name, folder_ / file.name);
    remove_obsolete(manifest);
    rename_or_refuse(committed / kManifest, folder_ / kManifest);
    earlier_ = manifest;
  }
  remove_own(committed);
  sync_folder(folder_);
}

// As a folder where that has nothing else in it, so that the frames of two results hardly mix.
void ResultFolder::take_frames(const Manifest& manifest) const {
  const fs::path committed = folder_ / kCommitted;
  const fs::path frames = folder_ / kFrames;
  const bool are_all_here = std::ranges::all_of(manifest, [&](const ResultFile& file) {
    return !is_frame(file.name) || is_there(committed / file.name);
  });
  if (are_all_here && has_only_own_frames()) {
    make_folder(committed / kEarlier);
    rename_or_refuse(frames, committed / kEarlier / kFrames);
  }
  if (is_there(committed / kFrames) && !is_there(frames))
    rename_or_refuse(committed / kFrames, frames);
}

bool ResultFolder::has_only_own_frames() const {
  bool is_empty = true;
  for (const std::string& name : names_below(folder_)) {
    if (!is_frame(name)) continue;
    if (!is_own(name)) return false;
    is_empty = false;
  }
  return !is_empty;
}

void ResultFolder::remove_obsolete(const Manifest& manifest) const {
  bool are_frames_among = false;
  for (const ResultFile& file : earlier_) {
    if (names(manifest, file.name) || !is_own(file.name)) continue;
    ::unlink((folder_ / file.name).c_str());
    are_frames_among |= is_frame(file.name);
  }
  if (are_frames_among) ::rmdir((folder_ / kFrames).c_str());
}

}  // namespace foldless
