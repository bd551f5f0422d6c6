// SPDX-License-Identifier: GPL-3.0-or-later
// Manifests of results: none names a file that solve does not write, and they read as they were
// written.
#include "app/cli/manifest.h"
#include "tests/fuzz/input.h"
#include "tests/support/temporary_folder.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foldless;
  static const test::TemporaryFolder folder;
  folder.write(kManifest, fuzz::Input(data, size).rest());
  fuzz::refuse_or_do([&] {
    const Manifest manifest = read_manifest(folder.path());
    for (const ResultFile& file : manifest)
      fuzz::expect(is_result_name(file.name) && file.name.find("..") == file.name.npos,
                   "a manifest names files of its folder");
    folder.write(kManifest, text_of(manifest));
    fuzz::expect(read_manifest(folder.path()) == manifest, "manifests read as they were written");
  });
  return 0;
}
