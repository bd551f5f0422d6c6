// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace foldless {

/// All bytes of a file. Throws Error when it is missing, a folder, unreadable or larger than 1 GiB.
std::string read_file(const std::filesystem::path& file);

/// The same bytes block by block, for what need not hold them all.
void read_blocks(const std::filesystem::path& file,
                 const std::function<void(std::string_view)>& take);

/// Replaces a file as a whole: the bytes go to a temporary file in the same folder, reach the
/// disk and then take the name, so that whatever happens either the old or the new file is there.
/// Permissions of a replaced file are kept; a symbolic link is followed; a device or pipe is
/// written to. Throws Error when that fails, and leaves no temporary file; that of a process that
/// was killed is removed by the next that writes the same file.
void write_file_atomically(const std::filesystem::path& file, std::string_view bytes);
/// The same with bytes that are in several places, one after the other.
void write_file_atomically(const std::filesystem::path& file,
                           std::span<const std::string_view> parts);

/// Writes a file that is not there, and waits until it has reached the disk. Throws Error, which
/// speaks of the file `told`, and may leave a part of it: for folders that go then.
void write_new_file(const std::filesystem::path& file, std::string_view bytes,
                    const std::filesystem::path& told);
/// The same with bytes that are in several places, one after the other.
void write_new_file(const std::filesystem::path& file, std::span<const std::string_view> parts,
                    const std::filesystem::path& told);

/// Throws the Error that says why a file, or a folder, cannot be written and what to do about it.
/// `error` as of errno.
[[noreturn]] void refuse_writing(const std::filesystem::path& file, int error);

/// How the hidden names begin under which a file or a folder is made beside where it will be:
/// `.NAME.foldless-`, of a long name the first 200 bytes. Six letters or digits follow.
std::string staged_prefix(const std::filesystem::path& result);

/// Waits until the names in a folder have reached the disk, where the file system can do that.
void sync_folder(const std::filesystem::path& folder);

}  // namespace foldless
