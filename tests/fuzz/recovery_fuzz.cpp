// SPDX-License-Identifier: GPL-3.0-or-later
// What is found of unsaved work: origin.json and two copies, of which the bytes 1 tell the ends.
#include <thread>

#include "app/editor/recovery.h"
#include "core/mesh/injective.h"
#include "tests/fuzz/input.h"
#include "tests/support/temporary_folder.h"

namespace foldless {
namespace {

/// Up to the next byte 1, which goes too.
std::string_view take_part(std::string_view& bytes) {
  const std::string_view part = bytes.substr(0, bytes.find('\1'));
  bytes.remove_prefix(std::min(part.size() + 1, bytes.size()));
  return part;
}

void expect_sound(const Document& document) {
  if (document.is_empty()) return;
  fuzz::expect(document.pose->is_valid(), "what is recovered is valid");
  for (const Handle& handle : document.handles)
    fuzz::expect(handle.vertex >= 0 && handle.vertex < document.pose->deformed.cols(),
                 "handles are at vertices");
}

}  // namespace
}  // namespace foldless

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foldless;
  static const test::TemporaryFolder folder;
  std::string_view bytes = fuzz::Input(data, size).rest();
  std::filesystem::create_directories(folder / "work");
  folder.write("work/lock", "");
  folder.write("work/origin.json", take_part(bytes));
  folder.write("work/000002.json", take_part(bytes));
  folder.write("work/000001.json", take_part(bytes));
  Recovery recovery(folder.path(), {});
  recovery.find();
  fuzz::expect(recovery.is_open(), "copies are found");
  recovery.origin(0);
  while (!recovery.work() && recovery.problem().empty()) {
    recovery.poll();
    std::this_thread::yield();
  }
  fuzz::expect(recovery.problem().find('\n') == std::string::npos, "a problem is one line");
  if (recovery.work()) expect_sound(recovery.work()->document);
  return 0;
}
