// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command_line.h"

#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <string_view>

#include "app/cli/calls.h"
#include "app/cli/streams.h"
#include "core/exception_words.h"

namespace foldless {
namespace {

/// Runs whatever was called.
struct Runner {
  const EditorCalls& editor;

  int operator()(const EditorCall& call) const { return editor.open(call.file, call.record); }
  int operator()(const ReplayCall& call) const {
    const int count = editor.replay(call.session, call.shots, call.size);
    std::cout << count << (count == 1 ? " picture" : " pictures") << " in " << call.shots.string()
              << '\n';
    return kExitDone;
  }
  int operator()(const EditorPictureCall& call) const {
    save_png(call.picture, editor.picture(call.file, call.size, call.theme),
             {{"Software", "Foldless"}, {"Scene", call.file.string()}});
    return kExitDone;
  }
  int operator()(const SolveCall& call) const { return solve(call); }
  int operator()(const AnimateCall& call) const { return animate(call); }
  int operator()(const RenderCall& call) const { return render(call); }
  int operator()(const MeshCall& call) const { return mesh(call); }
  int operator()(const CheckCall& call) const { return check(call); }
  int operator()(const CompareCall& call) const { return compare(call); }
  int operator()(const BenchCall& call) const { return bench(call); }
  int operator()(const TextCall& call) const {
    std::cout << call.text;
    return kExitDone;
  }
};

/// Libraries have functions that ask for memory and say that they throw nothing.
[[noreturn]] void end_without_memory() {
  try {
    if (std::current_exception()) throw;
  } catch (const std::bad_alloc&) {
    constexpr std::string_view kWords = "foldless: there is not enough memory\n";
    if (::write(STDERR_FILENO, kWords.data(), kWords.size()) > 0) ::_exit(kExitBadInput);
  } catch (...) {
    std::abort();
  }
  std::abort();
}

/// One line, whatever the message.
std::string line_of(std::string message) {
  for (char& c : message)
    if (c == '\n' || c == '\r') c = ' ';
  return "foldless: " + message + '\n';
}

}  // namespace

int run_command_line(int argc, const char* const* argv, const EditorCalls& editor) {
  std::set_terminate(end_without_memory);
  try {
    prepare_streams();
    const int status = std::visit(Runner{editor}, parse_arguments(argc, argv));
    expect_output_arrived();
    return status;
  } catch (const std::exception& error) {
    std::cerr << line_of(words_of_exception(error));
  } catch (...) {
    std::cerr << "foldless: failed for an unknown reason\n";
  }
  return kExitBadInput;
}

}  // namespace foldless
