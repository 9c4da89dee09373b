# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash disable=SC2154
# What packaging/run and packaging/test share. To be sourced, under bash, with `here` set.

root="$(cd "$here/.." && pwd)"
# the same words and numbers wherever it runs
export LC_ALL=C.UTF-8 TZ=UTC
export HOME="${HOME:-$(mktemp -d)}"

say() { printf '== %s\n' "$*"; }
fail() {
  printf '%s\n' "$*" >&2
  exit 1
}

# packages_of SECTION…: the packages listed under these sections of packaging/dependencies
packages_of() {
  local line section="" name
  while IFS= read -r line || [ -n "$line" ]; do
    line="${line%%#*}"
    line="${line//[[:space:]]/}"
    case "$line" in
      "") ;;
      \[*\]) section="${line:1:-1}" ;;
      *) for name in "$@"; do [ "$name" != "$section" ] || printf '%s\n' "$line"; done ;;
    esac
  done < "$here/dependencies"
}

# install_missing SECTION…: does nothing, and asks no network, where all is there
install_missing() {
  command -v apt-get > /dev/null ||
    fail "This script installs with apt-get and found none: it is made for Debian 12."
  local package missing=() as_root=()
  for package in $(packages_of "$@"); do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2> /dev/null)" = installed ] ||
      missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  if [ "$(id -u)" -ne 0 ]; then
    if command -v sudo > /dev/null && sudo -n true 2> /dev/null; then
      as_root=(sudo -n env DEBIAN_FRONTEND=noninteractive)
    else
      echo "Some packages are missing; as root, run this line, then start again:" >&2
      echo "apt-get update && apt-get install -y --no-install-recommends ${missing[*]}"
      exit 4
    fi
  fi
  say "Installing ${#missing[@]} packages: ${missing[*]}"
  export DEBIAN_FRONTEND=noninteractive
  "${as_root[@]}" apt-get -qq update ||
    fail "The package lists could not be fetched: check the network and /etc/apt."
  "${as_root[@]}" apt-get -qq install -y --no-install-recommends "${missing[@]}" > /dev/null ||
    fail "apt-get could not install what is missing; the reason stands above."
}

# fetch_kernel FOLDER: puts Debian's package of its kernel there, which the drivers' tests boot; does
# nothing, and asks no network, where one is there. Without one those tests are skipped.
fetch_kernel() {
  local folder="$1" package
  ! compgen -G "$folder/linux-image-*.deb" > /dev/null || return 0
  say "Fetching Debian's kernel for the drivers' tests, 70 MB."
  package="$(apt-cache depends linux-image-amd64 2> /dev/null | sed -n 's/^ *Depends: *//p' | head -n 1)"
  rm -rf "$folder/coming"
  mkdir -p "$folder/coming"
  if [ -n "$package" ] &&
    (cd "$folder/coming" && timeout 300 apt-get -qq download "$package") > /dev/null 2>&1; then
    mv "$folder/coming"/*.deb "$folder/"
  else
    echo "It could not be fetched: the drivers' tests on a real kernel will be skipped." >&2
  fi
  rm -rf "$folder/coming"
}

# quietly LOG COMMAND…: its output goes to a log, and is shown only if it fails
quietly() {
  local log="$1"
  shift
  mkdir -p "$(dirname "$log")"
  "$@" > "$log" 2>&1 || {
    tail -n 60 "$log" >&2
    return 1
  }
}

# configure PRESET OPTION…
configure() {
  say "Configuring $1."
  quietly "$root/build/$1.configure.log" cmake --preset "$@" -S "$root" ||
    fail "CMake could not configure '$1'; see build/$1.configure.log."
}

# build PRESET TARGET…
build() {
  local preset="$1"
  shift
  say "Building $preset."
  quietly "$root/build/$preset.build.log" cmake --build "$root/build/$preset" --target "$@" ||
    fail "The build of '$preset' failed; see build/$preset.build.log."
}

# virtual_display COMMAND…: runs it under an X server of its own
virtual_display() {
  env -u WAYLAND_DISPLAY QT_QPA_PLATFORM=xcb \
    xvfb-run -a -s "-screen 0 1280x900x24 +extension GLX" "$@"
}
