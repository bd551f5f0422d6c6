// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/layered/zip_archive.h"

#include <algorithm>
#include <memory>

#include "core/error.h"
#include "render/layered/zip.h"

namespace foldless {
namespace {

/// Memory is taken as bytes come, not as many as the archive claims.
constexpr std::uint64_t kPieceBytes = 1 << 20;

struct CloseEntry {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};

Error damaged_entry(const std::string& name) {
  return Error(name + " in the archive is damaged or locked");
}

}  // namespace

bool is_zip(std::string_view bytes) { return bytes.starts_with("PK\x03\x04"); }

ZipArchive::ZipArchive(std::string_view bytes) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  if (source) archive_ = zip_open_from_source(source, ZIP_RDONLY, &error);
  const std::string reason = archive_ ? "" : zip_error_strerror(&error);
  zip_error_fini(&error);
  if (archive_) return;
  zip_source_free(source);
  throw Error("the archive is damaged (" + reason + ")");
}

ZipArchive::~ZipArchive() { zip_discard(archive_); }

bool ZipArchive::has(const std::string& name) const {
  return zip_name_locate(archive_, name.c_str(), 0) >= 0;
}

std::string ZipArchive::read(const std::string& name, std::uint64_t most) const {
  zip_stat_t status;
  if (zip_stat(archive_, name.c_str(), 0, &status) != 0)
    throw Error("there is no " + name + " in the archive");
  if (!(status.valid & ZIP_STAT_SIZE)) throw damaged_entry(name);
  if (status.size > most)
    throw Error(name + " in the archive unpacks to more than " + std::to_string(most >> 20) +
                " MiB");
  const std::unique_ptr<zip_file_t, CloseEntry> file(zip_fopen_index(archive_, status.index, 0));
  if (!file) throw damaged_entry(name);
  std::string bytes;
  while (bytes.size() < status.size) {
    const std::size_t before = bytes.size();
    bytes.resize(before + std::min(kPieceBytes, status.size - before));
    const zip_int64_t count = zip_fread(file.get(), bytes.data() + before, bytes.size() - before);
    if (count <= 0) throw damaged_entry(name);
    bytes.resize(before + static_cast<std::size_t>(count));
  }
  char past_end = 0;
  // The last read sees whether the checksum is right, and that nothing follows.
  if (zip_fread(file.get(), &past_end, 1) != 0) throw damaged_entry(name);
  return bytes;
}

}  // namespace foldless
