// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/staged.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/error.h"
#include "core/files/atomic_file.h"
#include "core/files/folder_names.h"
#include "core/files/left_over.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& result) { return fs::absolute(result).parent_path(); }

/// Six letters or digits, as mkstemp() gives them.
bool is_random_part(std::string_view text) {
  return text.size() == 6 && std::ranges::all_of(text, [](char c) {
           return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
         });
}

}  // namespace

void remove_leftovers(const fs::path& result) {
  const std::string prefix = staged_prefix(result);
  const fs::path folder = folder_of(result);
  for (const std::string& name : names_in_folder(folder))
    if (name.starts_with(prefix) && is_random_part(name.substr(prefix.size())))
      remove_left_over(folder / name);
}

Staged::Staged(fs::path result, What what) : result_(std::move(result)) {
  remove_leftovers(result_);
  // Another process may take it for a leftover before it is locked.
  while (!make(what)) {
  }
}

bool Staged::make(What what) {
  std::string name = folder_of(result_) / (staged_prefix(result_) + "XXXXXX");
  if (what == What::folder) {
    if (!::mkdtemp(name.data())) refuse_writing(result_, errno);
    lock_ = ::open(name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  } else {
    lock_ = ::mkostemp(name.data(), O_CLOEXEC);
    if (lock_ < 0) refuse_writing(result_, errno);
  }
  path_ = name;
  std::error_code ignored;
  fs::permissions(path_, fs::perms(what == What::folder ? 0755 : 0644), fs::perm_options::replace,
                  ignored);
  if (lock_ < 0) return true;  // It can be made all the same.
  if (lock_new(lock_, path_)) return true;
  ::close(std::exchange(lock_, -1));
  return false;
}

Staged::~Staged() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
  if (lock_ >= 0) ::close(lock_);
}

void Staged::take_name(const fs::path& name) {
  if (lock_ >= 0 && ::fsync(lock_) != 0) {
    const int error = errno;
    if (fs::is_regular_file(path_)) refuse_writing(result_, error);  // of a folder it may be unable
  }
  if (::rename(path_.c_str(), name.c_str()) != 0) refuse_writing(result_, errno);
  path_.clear();
  sync_folder(folder_of(name));
}

}  // namespace foldless
