# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash disable=SC2154
# What packaging/run and packaging/test share. To be sourced, under bash, with `here` set.

root="$(cd "$here/.." && pwd)"
# the same words and numbers wherever it runs
export LC_ALL=C.UTF-8 TZ=UTC
export HOME="${HOME:-$(mktemp -d)}"

# whether the compiler is asked through ccache
cache=ON

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
  if [ -n "$(dpkg --audit)" ]; then
    say "An installation before this one was cut off: dpkg ends it first."
    followed "$root/build/install.log" "configured" "${as_root[@]}" dpkg --configure -a ||
      fail "dpkg could not end an installation that was cut off; the reason stands above."
  fi
  "${as_root[@]}" apt-get -qq update ||
    fail "The package lists could not be fetched: check the network and /etc/apt."
  followed "$root/build/install.log" "installed" \
    "${as_root[@]}" apt-get install -y --no-install-recommends "${missing[@]}" ||
    fail "apt-get could not install what is missing; the reason stands above."
}

# fetch_for_tests: what tests need of Debian's packages without their being installed
fetch_for_tests() {
  fetch_kernel "$root/build/kernel"
  fetch_pacs "$root/build/pacs"
}

# fetch_kernel FOLDER: puts Debian's package of its kernel there, which the drivers' tests boot, and unpacks
# udev in FOLDER/udev; does nothing, and asks no network, where they are there. Without them those tests are
# skipped.
fetch_kernel() {
  local folder="$1" package
  unpack "$folder/udev" bin/udevadm "udev for the tests of its rules, 5 MB" udev systemd
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

# fetch_pacs FOLDER: unpacks Debian's Orthanc there, with its DICOMweb plugin, and gnome-keyring, for the
# tests of palpate-fetch. They are not installed: a PACS would start and listen, a keyring would be
# started with every session. Without them those tests are skipped.
fetch_pacs() {
  unpack "$1" usr/sbin/Orthanc "Orthanc for the tests with a PACS, 5 MB" orthanc orthanc-dicomweb
  unpack "$1" usr/bin/gnome-keyring-daemon "gnome-keyring for a test with a PACS, 2 MB" gnome-keyring
}

# unpack FOLDER PROGRAM WHAT PACKAGE…: unpacks Debian's packages in a folder, with what of their libraries
# is not installed; does nothing, and asks no network, where the program lies there or is installed.
unpack() {
  local folder="$1" program="$2" what="$3" packages package
  shift 3
  [ ! -x "$folder/$program" ] && ! command -v "${program##*/}" > /dev/null || return 0
  say "Fetching Debian's $what."
  mkdir -p "$folder/coming"
  mapfile -t packages < <(apt-get install -s --no-install-recommends "$@" 2> /dev/null |
    sed -n 's/^Inst \([^ ]*\).*/\1/p')
  if [ ${#packages[@]} -gt 0 ] &&
    (cd "$folder/coming" && timeout 300 apt-get -qq download "${packages[@]}") > /dev/null 2>&1; then
    for package in "$folder/coming"/*.deb; do dpkg-deb -x "$package" "$folder"; done
  else
    echo "It could not be fetched: these tests will be skipped." >&2
  fi
  rm -rf "$folder/coming"
}

# minutes SECONDS: as people say it
minutes() { printf '%d:%02d' "$(($1 / 60))" "$(($1 % 60))"; }

# on_these_cores SERIAL PARALLEL: whole minutes that so many seconds take here, of which the second
# kind is shared out to all cores
on_these_cores() { echo "$((($1 + $2 / $(nproc) + 59) / 60))"; }

# followed LOG WHAT COMMAND…: runs it with its output in a log, and shows how far it is: where ninja
# says "[12/340]" or ctest " 12/340 Test", "WHAT: 12 of 340". In place on a terminal, elsewhere a line
# each half a minute. Where none has ended in that time, the tests that run are named. The last lines
# of a test that fails are shown when it does, those of the log if the whole fails.
followed() {
  local log="$1" what="$2" status
  shift 2
  mkdir -p "$(dirname "$log")"
  "$@" 2>&1 | tee "$log" | show_progress "$what"
  status="${PIPESTATUS[0]}"
  [ "$status" -eq 0 ] || tail -n 40 "$log" >&2
  return "$status"
}

# show_progress WHAT: of what is read; see `followed`
show_progress() {
  local what="$1" began=$SECONDS said=$SECONDS every=30 terminal=false
  local status line read_so_far="" far="begun" told="" failing=false last=()
  local -A running=()
  local erase=""
  if [ -t 1 ]; then terminal=true every=1 erase=$'\r\033[K'; fi
  while :; do
    status=0
    IFS= read -r -t "$every" line || status=$?
    if [ "$status" -eq 0 ]; then
      line="$read_so_far$line" read_so_far=""
      if [[ "$line" =~ ^\ *\[?([0-9]+)/([0-9]+)(\]|\ Test\ ) ]]; then
        far="${BASH_REMATCH[1]} of ${BASH_REMATCH[2]}"
        [[ "$line" =~ \ #([0-9]+): ]] && unset "running[${BASH_REMATCH[1]}]"
        [ ${#last[@]} -eq 0 ] || printf '%s\n' "${last[@]}"
        failing=false last=()
        # such a line of ctest ends in stars and what happened, where a test did not pass
        if [[ "$line" =~ \ Test\ .*\*\*\*(Failed|Timeout|Exception|Not\ Run) ]]; then
          failing=true last=("${erase}$line")
        fi
      elif [[ "$line" =~ ^\ *Start\ +([0-9]+):\ (.*) ]]; then
        running["${BASH_REMATCH[1]}"]="${BASH_REMATCH[2]}"
      elif $failing; then
        last+=("   $line")
        [ ${#last[@]} -le 60 ] || last=("${last[0]}" "${last[@]:2}")
      fi
    elif [ "$status" -gt 128 ]; then
      read_so_far+="$line" # the time was up in the middle of a line
    else
      break
    fi
    [ $((SECONDS - said)) -ge "$every" ] || continue
    said=$SECONDS
    if $terminal; then
      printf '%s   %s: %s, %s' "$erase" "$what" "$far" "$(minutes $((SECONDS - began)))"
    else
      printf '   %s: %s, %s' "$what" "$far" "$(minutes $((SECONDS - began)))"
      [ "$far" != "$told" ] || [ ${#running[@]} -eq 0 ] || printf ' (%s)' "$(IFS=,; echo "${running[*]}")"
      printf '\n'
      told="$far"
    fi
  done
  [ ${#last[@]} -eq 0 ] || printf '%s\n' "${last[@]}"
  printf '%s   %s: %s, %s\n' "$erase" "$what" "$far" "$(minutes $((SECONDS - began)))"
}

# configure PRESET OPTION…
configure() {
  say "Configuring $1."
  followed "$root/build/$1.configure.log" "configured" cmake --preset "$@" -DPALPATE_CACHE="$cache" -S "$root" ||
    fail "CMake could not configure '$1'; see build/$1.configure.log."
}

# build PRESET TARGET…
build() {
  local preset="$1"
  shift
  say "Building $preset."
  followed "$root/build/$preset.build.log" "built" \
    cmake --build "$root/build/$preset" --target "$@" ||
    fail "The build of '$preset' failed; see build/$preset.build.log."
}

# virtual_display COMMAND…: runs it under an X server of its own
virtual_display() {
  env -u WAYLAND_DISPLAY QT_QPA_PLATFORM=xcb \
    xvfb-run -a -s "-screen 0 1280x900x24 -noreset +extension GLX" "$@"
}
