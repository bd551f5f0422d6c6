#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# scenes_test.sh TREE BUILD: the scenes of benchmark/ are those that its generator draws, and its checker says of results of
# foldless for three of them that they are reached.
set -euo pipefail
tree=$1
export PATH=$2:$PATH
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r "$tree/benchmark/generate" "$work"
"$work/generate" "$work/drawn"
diff -r "$tree/benchmark/scenes" "$work/drawn"

mkdir "$work/scenes"
for scene in hard2611-009-swap hard2611-011-stretched seed2611-006-disk-lscm-easy; do
  cp "$work/drawn/$scene.json" "$work/scenes"
done
foldless solve "$work/scenes" -o "$work/foldless" --quiet
python3 "$tree/benchmark/check.py" "$work/scenes" "$work/foldless" >"$work/table"
grep --quiet '^| foldless | 3/3 |' "$work/table" || { cat "$work/table" && exit 1; }
