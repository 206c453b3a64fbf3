#!/usr/bin/env bash
# segment_head.sh [--build DIR] [--threads N] [--rms R]: bone in a CT of the head by level sets, slice by slice and as a
# volume, beside ITK's (libinsighttoolkit5-dev) where that is installed. The head is Debian's invesalius-examples.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$(cd "$here/../.." && pwd)/build/release
threads=$(nproc)
rms=0.01
while [ $# -gt 0 ]; do
  case $1 in
    --build) build=$(cd "$2" && pwd) && shift ;;
    --threads) threads=$2 && shift ;;
    --rms) rms=$2 && shift ;;
    *) echo "usage: segment_head.sh [--build DIR] [--threads N] [--rms R]" >&2 && exit 2 ;;
  esac
  shift
done
archive=/usr/share/doc/invesalius-examples/examples/Cranium.inv3
[ -f "$archive" ] || { echo "install invesalius-examples for the head" >&2; exit 3; }
cmake --build "$build" --target segment_head >&2
cmake --build "$build" --target rival_itk_level_set >&2 2>/dev/null || echo "rival skipped: install libinsighttoolkit5-dev" >&2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
tar -xOf "$archive" --wildcards '*/matrix.dat' >"$scratch/matrix"

line() { echo "| $1 | $2 | $(tr '\n' '|' | sed 's/|[a-z_]* / | /g; s/^[a-z_]* //; s/|$/ |/')"; }
echo "| what | program | seconds | steps | peak, GB | Dice with the rival |"
echo "| --- | --- | --- | --- | --- | --- |"
for what in slices volume; do
  region=()
  if [ -x "$build/bin/rival_itk_level_set" ]; then
    region=("$scratch/$what")
    "$build/bin/rival_itk_level_set" "$scratch/matrix" $what "$threads" "$rms" "$scratch/$what" | line $what ITK
  fi
  "$build/bin/segment_head" "$scratch/matrix" $what "$threads" "$rms" "${region[@]}" | line $what isostack
done
