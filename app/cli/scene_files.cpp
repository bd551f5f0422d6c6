// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/scene_files.h"

#include <algorithm>

#include "core/error.h"
#include "core/files/atomic_file.h"
#include "core/files/text_lines.h"
#include "core/scene/embedding.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> scenes_in_folder(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::ranges::sort(files);
  if (const fs::path input = folder / "input.obj"; fs::exists(input) && is_embedding(input))
    files.push_back(input);
  if (files.empty())
    throw Error(folder.string() +
                ": has no scene, neither a file that ends with .json nor input.obj with "
                "handles.txt");
  return files;
}

std::vector<fs::path> scenes_in_list(const fs::path& list) {
  std::vector<fs::path> files;
  const std::string text = read_file(list);
  for (TextLines lines(text); lines.next();)
    if (!lines.line().empty()) files.push_back(list.parent_path() / std::string(lines.line()));
  if (files.empty()) throw Error(list.string() + ": names no scene; write one a line");
  return files;
}

}  // namespace

bool are_scenes(const fs::path& path) {
  return fs::is_directory(path) || path.extension() == ".txt";
}

std::vector<fs::path> scene_files(const std::vector<fs::path>& named) {
  std::vector<fs::path> files;
  for (const fs::path& path : named) {
    std::vector<fs::path> more{path};
    if (fs::is_directory(path))
      more = scenes_in_folder(path);
    else if (path.extension() == ".txt")
      more = scenes_in_list(path);
    files.insert(files.end(), more.begin(), more.end());
  }
  return files;
}

std::string name_of_scene(const fs::path& file) {
  return (is_embedding(file) ? fs::absolute(file).parent_path().filename() : file.stem()).string();
}

}  // namespace foldless
