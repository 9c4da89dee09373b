#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Renders the icon of the programs in the sizes of the hicolor theme: palpate-SIZE.png in the folder
# that is named, or here. Needs rsvg-convert (librsvg2-bin). Small sizes have a drawing of their own.
set -eu
here="$(cd "$(dirname "$0")" && pwd)"
out="${1:-$here}"
for size in 16 22 24 32 48 64 128 256 512; do
  drawing="$here/../palpate.svg"
  [ "$size" -gt 24 ] || drawing="$here/palpate-small.svg"
  rsvg-convert --width "$size" --height "$size" --output "$out/palpate-$size.png" "$drawing"
done
