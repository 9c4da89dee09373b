#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Makes resources/touch.webp: the window on the demo skull while a simulated hand slides the tool
# over the bone, and the isovalue moves from bone to flesh and back. The window is the real one. Its
# frames are grabbed as they come; the pauses between them are left out, since without a graphics
# card few are drawn a second.
#
#   resources/moving_picture.sh [PALPATE [OUT.webp]]
#
# Needs the packages xvfb, xdotool and ffmpeg. PALPATE is build/release/app/palpate by default.
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
palpate="${1:-$root/build/release/app/palpate}"
out="${2:-$root/resources/touch.webp}"

pace="${PACE:-1}"        # a busy machine needs more: all waits are this many times as long
seconds=34               # of grabbing
slides=13                # of these before the isovalue moves
grabbed=12               # frames a second
shown=9                  # seconds of the picture
fastest=12               # frames a second of the picture: of more, each n-th is taken
size=1280x840            # of the window at its first start
width=800                # of the picture
most=3000000             # bytes
histogram=150            # its y in that window
bone=176 flesh=160       # x of 300 HU and of some 90 HU there

for program in Xvfb xdotool ffmpeg; do
  command -v "$program" > /dev/null || { echo "$program is missing; see the head of this script." >&2; exit 4; }
done
times() { awk "BEGIN { print $1 * $pace }"; }
work="$(mktemp -d)"
started=()
end() {
  set +e
  # the window before its screen
  for ((n = ${#started[@]} - 1; n >= 0; --n)); do
    kill "${started[n]}" 2> /dev/null && wait "${started[n]}" 2> /dev/null
  done
  rm -rf "$work"
}
trap end EXIT

# a screen of its own, as large as the window, and preferences of nobody
mkfifo "$work/display"
Xvfb -displayfd 3 -screen 0 "${size}x24" -noreset -nolisten tcp 3> "$work/display" 2> /dev/null &
started+=($!)
read -r number < "$work/display"
export DISPLAY=":$number" HOME="$work" XDG_CONFIG_HOME="$work" XDG_DATA_HOME="$work"
# a soft spring: the device is then seen well inside
mkdir "$work/Palpate"
printf '[coupling]\nstiffness=250\n' > "$work/Palpate/Palpate.conf"
"$palpate" --phantom demo --tool drill --hand slide --no-notice &
started+=($!)
window="$(timeout 120 xdotool search --sync --onlyvisible --name demo | head -n 1)"
xdotool windowmove "$window" 0 0 windowsize "$window" ${size/x/ } windowfocus "$window"
sleep 8

# nearer, at the place where the hand slides
xdotool mousemove 585 385
for _ in $(seq 9); do xdotool click 4; sleep 0.2; done
sleep "$(times 10)"

ffmpeg -loglevel error -f x11grab -framerate "$grabbed" -video_size "$size" -i "$DISPLAY" \
  -t "$(times "$seconds")" -c:v ffv1 "$work/grabbed.mkv" &
grabber=$!
sleep "$(times "$slides")"
xdotool mousemove "$bone" "$histogram" mousedown 1
for x in $(seq "$bone" -1 "$flesh"); do xdotool mousemove "$x" "$histogram"; sleep "$(times 0.5)"; done
sleep "$(times 2)"
for x in $(seq "$flesh" 1 "$bone"); do xdotool mousemove "$x" "$histogram"; sleep "$(times 0.5)"; done
xdotool mouseup 1 mousemove 700 700
wait "$grabber"

mkdir "$work/frames"
ffmpeg -loglevel error -i "$work/grabbed.mkv" -fps_mode vfr \
  -vf "mpdecimate=hi=64*4:lo=64*2:frac=0.001,scale=$width:-2:flags=lanczos" "$work/frames/%04d.png"
count="$(find "$work/frames" -name '*.png' | wc -l)"
nth="$((count / (shown * fastest) + 1))"
ffmpeg -loglevel error -y -framerate "$((count / nth / shown + 1))" -i "$work/frames/%04d.png" \
  -vf "select='not(mod(n,$nth))',setpts=N/FRAME_RATE/TB" \
  -c:v libwebp_anim -quality 70 -compression_level 4 -loop 0 "$out"
bytes="$(stat -c %s "$out")"
[ "$bytes" -lt "$most" ] || { echo "$out has $bytes bytes; fewer than $most are wanted." >&2; exit 1; }
echo "$out: $count frames, $bytes bytes"
