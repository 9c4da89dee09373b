#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Makes the pictures of resources/help anew, of the window that a build with tests has (build/release).
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
build="${1:-$root/build/release}"
scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT
# the test fails where a picture changes, which is what is wanted here
HOME="$scratch" TMPDIR="$scratch" LC_ALL=C.UTF-8 TZ=UTC xvfb-run -a -s "-screen 0 1280x900x24 -noreset +extension GLX" \
  "$build/tests/ui/window_test" --gtest_filter=Help.PicturesShowTheWindowAsItIs > "$scratch/said" || true
mkdir -p "$root/resources/help/pictures"
for picture in "$scratch"/palpate-window-tests/help_*.png; do
  [ -f "$picture" ] || { cat "$scratch/said" >&2; exit 1; }
  name="${picture##*/help_}"
  cp "$picture" "$root/resources/help/pictures/$name"
  echo "resources/help/pictures/$name"
done
