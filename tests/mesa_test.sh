#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Mesa is loaded where something is drawn and nowhere else: mesa_test.sh PROGRAM ASSETS.
set -euo pipefail
program=$1 assets=$2
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
failed=0
complain() {
  printf '%s\n' "$*"
  failed=1
}

if ldd "$program" | grep --extended-regexp 'OSMesa|LLVM'; then complain 'it starts with them'; fi

# A library of Mesa's name that is none: what draws cannot go on, what does not draw can.
echo 'no library' >"$folder/libOSMesa.so.8"
export LD_LIBRARY_PATH=$folder
scene=$assets/scenes/figure12_splits.json
"$program" solve "$scene" -o "$folder/solved" >/dev/null || complain 'solve needs Mesa'
status=0
words=$("$program" render "$scene" -o "$folder/picture.png" 2>&1) || status=$?
[ "$status" -eq 2 ] || complain "render ends with $status without Mesa"
[[ $words == 'foldless: pictures cannot be drawn: '*'; install libosmesa6' ]] ||
  complain "render says: $words"
[ ! -e "$folder/picture.png" ] || complain 'render leaves a file without Mesa'
exit $failed
