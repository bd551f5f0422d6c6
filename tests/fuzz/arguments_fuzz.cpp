// SPDX-License-Identifier: GPL-3.0-or-later
// Command lines, an argument a line.
#include "app/cli/calls.h"
#include "tests/fuzz/input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foldless;
  std::vector<std::string> words{"foldless"};
  for (const char c : fuzz::Input(data, size).rest()) {
    if (c == '\0') break;
    if (c == '\n')
      words.emplace_back();
    else if (words.size() > 1)
      words.back() += c;
  }
  std::vector<const char*> arguments;
  for (const std::string& word : words) arguments.push_back(word.c_str());
  fuzz::refuse_or_do(
      [&] { parse_arguments(static_cast<int>(arguments.size()), arguments.data()); });
  return 0;
}
