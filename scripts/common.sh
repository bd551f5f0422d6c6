# SPDX-License-Identifier: GPL-3.0-or-later
# Functions that the scripts of this folder share. Source it; it does nothing itself.

project_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf 'foldless: %s\n' "$*"; }

fail() {
  printf 'foldless: %s\n' "$*" >&2
  exit 1
}

# packages_in LIST...: the names in scripts/packages/LIST.
packages_in() {
  local list
  for list in "$@"; do
    sed -e 's/#.*//' -e '/^[[:space:]]*$/d' "$project_dir/scripts/packages/$list"
  done
}

# missing_packages NAME...: those that are not installed, one a line.
missing_packages() {
  local installed
  installed=$(dpkg-query --show --showformat '${db:Status-Status} ${Package}\n' "$@" 2>/dev/null |
    sed -n 's/^installed //p' || true)
  printf '%s\n' "$@" | grep --invert-match --line-regexp --fixed-strings "$installed" || true
}

# as_root COMMAND...: runs it as root, through sudo where we are not root.
as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

may_become_root() {
  [ "$(id -u)" -eq 0 ] && return
  command -v sudo >/dev/null && { [ -t 0 ] || sudo -n true 2>/dev/null; }
}

apt_get() {
  as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=300 "$@"
}

# install_packages LIST...: installs what is missing of the packages in the lists.
install_packages() {
  command -v apt-get >/dev/null || fail "this script installs packages with apt (Debian 12);" \
    "elsewhere install the like of scripts/packages/* and run: cmake --preset release"
  local wanted missing
  mapfile -t wanted < <(packages_in "$@")
  mapfile -t missing < <(missing_packages "${wanted[@]}")
  [ ${#missing[@]} -eq 0 ] && return
  may_become_root || fail "packages are missing; as root run:" \
    "apt-get update && apt-get install --no-install-recommends ${missing[*]}"
  say "installing ${#missing[@]} packages: ${missing[*]}"
  apt_get update || say "apt-get update failed; trying with the package lists that are here"
  apt_get install --yes --no-install-recommends "${missing[@]}" >/dev/null || fail "could not install" \
    "${missing[*]}: check the network and /etc/apt/sources.list, then run this again"
}

# configure_in DIR PRESET [OPTION...]: runs cmake in a source tree, quietly, with ccache where it is
# installed. Without that sloppiness it keeps nothing that was made with precompiled headers.
configure_in() {
  local source_dir=$1 preset=$2 launcher=()
  shift 2
  if command -v ccache >/dev/null; then
    local ccache="env;CCACHE_SLOPPINESS=pch_defines,time_macros;ccache"
    launcher=("-DCMAKE_C_COMPILER_LAUNCHER=$ccache" "-DCMAKE_CXX_COMPILER_LAUNCHER=$ccache")
  fi
  (cd "$source_dir" && cmake --preset "$preset" --log-level=WARNING "${launcher[@]}" "$@" >/dev/null)
}

# configure PRESET: runs cmake where it has not run or the presets have changed since. Later changes
# of CMake files are noticed by the build itself.
configure() {
  local build_dir="$project_dir/build/$1"
  [ "$build_dir/build.ninja" -nt "$project_dir/CMakePresets.json" ] && return
  say "configuring build/$1"
  configure_in "$project_dir" "$1"
  touch "$build_dir/build.ninja"
}

# build PRESET [TARGET]: configures if need be and builds.
build() {
  configure "$1"
  say "building build/$1"
  cmake --build "$project_dir/build/$1" ${2:+--target "$2"}
}

# run_tests PRESET: runs the tests of a preset on all cores, with the output of those that fail. One
# more than there are cores: many wait for windows and other processes.
run_tests() {
  say "testing build/$1"
  (cd "$project_dir" && ctest --preset "$1" --parallel "$(($(nproc) + 1))")
}
