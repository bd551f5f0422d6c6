// SPDX-License-Identifier: GPL-3.0-or-later
// judge FILE.obj...: prints what keeps the meshes from being locally injective. Status 0: nothing.
#include <exception>
#include <fstream>
#include <iostream>

#include "tests/judge/judge.h"

int main(int argc, char** argv) {
  std::size_t count = 0;
  for (int i = 1; i < argc; ++i) {
    try {
      std::ifstream in(argv[i]);
      if (!in) throw std::runtime_error("cannot be read");
      for (const std::string& objection : judge::objections_to(judge::read_obj(in))) {
        std::cout << argv[i] << ": " << objection << '\n';
        ++count;
      }
    } catch (const std::exception& error) {
      std::cout << argv[i] << ": " << error.what() << '\n';
      ++count;
    }
  }
  std::cout << argc - 1 << " meshes, " << count << " objections\n";
  return count == 0 ? 0 : 1;
}
