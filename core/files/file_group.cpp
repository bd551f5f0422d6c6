// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/file_group.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "core/error.h"
#include "core/files/atomic_file.h"
#include "core/files/folder_names.h"
#include "core/files/staged.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;

fs::path committed_folder(const fs::path& main) {
  return main.parent_path() / (staged_prefix(main) + "committed");
}

[[noreturn]] void refuse_taking(const fs::path& file, int error) {
  throw Error(file.string() + ": cannot be written: " + std::generic_category().message(error));
}

void take_name(const fs::path& from, const fs::path& to) {
  if (::rename(from.c_str(), to.c_str()) != 0 && errno != ENOENT) refuse_taking(to, errno);
}

/// The rest of what a commit began.
void take_names(const fs::path& main) {
  const fs::path committed = committed_folder(main);
  if (!fs::is_directory(committed)) return;
  const fs::path new_main = committed / main.filename();
  if (fs::exists(new_main) && ::unlink(main.c_str()) != 0 && errno != ENOENT)
    refuse_taking(main, errno);
  for (const std::string& name : names_in_folder(committed))
    if (name != main.filename()) take_name(committed / name, main.parent_path() / name);
  sync_folder(main.parent_path());
  take_name(new_main, main);
  sync_folder(main.parent_path());
  std::error_code ignored;
  fs::remove_all(committed, ignored);
}

/// Writes a file that is to take the place of another.
void stage(const fs::path& staged, const fs::path& replaced, const std::string& bytes) {
  if (fs::is_directory(replaced)) refuse_taking(replaced, EISDIR);
  write_new_file(staged, bytes, replaced);
  std::error_code ignored;
  const fs::file_status status = fs::status(replaced, ignored);
  if (fs::is_regular_file(status)) fs::permissions(staged, status.permissions(), ignored);
}

}  // namespace

void write_files_together(const fs::path& main, const std::string& bytes,
                          const std::vector<NamedBytes>& others) {
  const fs::path whole = fs::absolute(main).lexically_normal();
  try {
    take_names(whole);
    Staged staged(whole, Staged::What::folder);
    for (const NamedBytes& other : others)
      stage(staged.path() / other.name, whole.parent_path() / other.name, other.bytes);
    stage(staged.path() / whole.filename(), whole, bytes);
    staged.take_name(committed_folder(whole));
    take_names(whole);
  } catch (const fs::filesystem_error& problem) {
    throw Error(main.string() + ": cannot be written: " + problem.code().message());
  }
}

}  // namespace foldless
