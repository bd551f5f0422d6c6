#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# words_of_help_test.sh FOLDER: the completion of bash completes commands, flags and files, and the
# manual page names every command and has no word that groff does not know.
set -euo pipefail

fail() {
  printf '%s\n' "$*" >&2
  exit 1
}

cd "$1"
source ./foldless
# completed WORD...: what the last word may become.
completed() {
  COMP_WORDS=("$@")
  COMP_CWORD=$(($# - 1))
  _foldless
  printf '%s\n' "${COMPREPLY[@]}"
}
[ "$(completed foldless so)" = solve ] || fail "so is not completed to solve"
[ "$(completed foldless solve --met)" = --method ] || fail "--met is not completed to --method"
[ "$(completed foldless check --met)" = "" ] || fail "check is given a flag of solve"
[ "$(completed foldless render foldless.1.)" = foldless.1.gz ] || fail "a file is not completed"

page=$(gzip --decompress --stdout foldless.1.gz)
for command in solve animate render mesh check compare replay bench; do
  grep -q "^.SS foldless $command" <<<"$page" || fail "the manual page does not name $command"
done
if command -v groff >/dev/null; then
  said=$(groff -K utf8 -ww -man -T utf8 <<<"$page" 2>&1 >/dev/null)
  [ -z "$said" ] || fail "groff: $said"
fi
