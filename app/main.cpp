// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli.h"
#include "app/gui/run_editor.h"

int main(int argc, char** argv) {
  return foldless::run_command_line(argc, argv, foldless::run_editor);
}
