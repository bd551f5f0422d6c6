#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Libraries of images, pictures, windows, fonts, archives and the desktop are loaded where they are used and nowhere else:
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

if ldd "$program" | grep --extended-regexp 'OSMesa|LLVM|cairo|glfw|X11|xcb|fontconfig|libzip|crypto|libgio|libpng|turbojpeg|webp|libgif|lzf'; then
  complain 'it starts with them'
fi

# Libraries of their names that are none: what needs them cannot go on, what does not can.
for library in libOSMesa.so.8 libcairo.so.2 libglfw.so.3 libfontconfig.so.1 libzip.so.4 libpng16.so.16 libturbojpeg.so.0 \
    libwebp.so.7 libgif.so.7; do
  echo 'no library' >"$folder/$library"
done
export LD_LIBRARY_PATH=$folder
scene=$assets/scenes/figure12_splits.json
"$program" solve "$scene" -o "$folder/solved" >/dev/null || complain 'solve needs one of them'

# refused FILE WORDS PACKAGE COMMAND INPUT
refused() {
  status=0
  words=$("$program" "$4" "$5" -o "$folder/$1" 2>&1) || status=$?
  [ "$status" -eq 2 ] || complain "$4 to $1 ends with $status"
  [[ $words == "foldless: $2: "*"; install $3" ]] || complain "$4 says: $words"
  [ ! -e "$folder/$1" ] || complain "$4 leaves $1"
}
refused picture.png 'pictures cannot be drawn' libosmesa6 render "$scene"
refused picture.svg 'figures cannot be drawn' libcairo2 render "$scene"

# Their first bytes, by which images are told from each other.
cd "$folder"
cp "$assets/images/editor.png" image.png
printf '\xff\xd8\xff' >image.jpg
printf 'RIFF....WEBPVP8 ' >image.webp
printf 'GIF89a' >image.gif
refused mesh.json 'image.png: PNG images can be neither read nor written' libpng16-16 mesh image.png
refused mesh.json 'image.jpg: JPEG images cannot be read' libturbojpeg0 mesh image.jpg
refused mesh.json 'image.webp: WebP images cannot be read' libwebp7 mesh image.webp
refused mesh.json 'image.gif: GIF images can be neither read nor written' libgif7 mesh image.gif
exit $failed
