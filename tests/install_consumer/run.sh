#!/usr/bin/env bash
# run.sh BUILD_DIR: installs that build into a scratch prefix and builds and runs the consumer project against it.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cmake --install "$1" --prefix "$scratch/prefix" >/dev/null
cmake -G Ninja -S "$here" -B "$scratch/build" -DCMAKE_PREFIX_PATH="$scratch/prefix" -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build "$scratch/build"
"$scratch/build/consumer" "$scratch/disc.ply"
"$scratch/prefix/bin/isostack" measure "$scratch/disc.ply"
