#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Makes the man pages of packaging/man from resources/help; with a folder, makes them there.
set -eu
here="$(cd "$(dirname "$0")" && pwd)"
out="${1:-$here/../man}"
scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT
sphinx-build -q -W -c "$here" -b man -d "$scratch/doctrees" "$here/../../resources/help" "$scratch/man"
mkdir -p "$out"
cp "$scratch/man/palpate.1" "$scratch/man/palpate-cli.1" "$scratch/man/palpate-fetch.1" "$out"
