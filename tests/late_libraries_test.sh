#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Libraries of pictures, windows, fonts, archives and the desktop are loaded where they are used and nowhere else:
# late_libraries_test.sh PROGRAM ASSETS.
set -euo pipefail
program=$1 assets=$2
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
failed=0
complain() {
  printf '%s\n' "$*"
  failed=1
}

if ldd "$program" | grep --extended-regexp 'OSMesa|LLVM|cairo|glfw|X11|xcb|fontconfig|libzip|crypto|libgio'; then
  complain 'it starts with them'
fi

# Libraries of their names that are none: what needs them cannot go on, what does not can.
for library in libOSMesa.so.8 libcairo.so.2 libglfw.so.3 libfontconfig.so.1 libzip.so.4; do
  echo 'no library' >"$folder/$library"
done
export LD_LIBRARY_PATH=$folder
scene=$assets/scenes/figure12_splits.json
"$program" solve "$scene" -o "$folder/solved" >/dev/null || complain 'solve needs one of them'

# refused PICTURE WORDS PACKAGE
refused() {
  status=0
  words=$("$program" render "$scene" -o "$folder/$1" 2>&1) || status=$?
  [ "$status" -eq 2 ] || complain "render of $1 ends with $status"
  [[ $words == "foldless: $2: "*"; install $3" ]] || complain "render says: $words"
  [ ! -e "$folder/$1" ] || complain "render leaves $1"
}
refused picture.png 'pictures cannot be drawn' libosmesa6
refused picture.svg 'figures cannot be drawn' libcairo2
exit $failed
