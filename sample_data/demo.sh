#!/usr/bin/env bash
# demo.sh [OUT_DIR]: installs what is missing, builds, and runs the main job on the generated sample:
# a DICOM series of an analytic organ becomes one closed surface, measured against the truth, and a picture.
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=$(realpath -m "${1:-$top/build/demo}")
cd "$top"

cmake/install-packages.sh
cmake --preset release -DISOSTACK_BUILD_TESTS=OFF
cmake --build --preset release
bin=$top/build/release/bin

mkdir -p "$out"
"$bin/isostack_make_phantom" "$out/sample"
"$bin/isostack" info "$out/sample/series"
"$bin/isostack" segment "$out/sample/series" --level 25 --curvature 1 --largest -o "$out/contours.vtp"
"$bin/isostack" reconstruct "$out/contours.vtp" -o "$out/organ.stl" --report "$out/report.json"
"$bin/isostack" measure "$out/organ.stl" --against "$out/sample/truth.stl"
xvfb-run -a "$bin/isostack" view "$out/organ.stl" "$out/contours.vtp" --screenshot "$out/organ.png" \
  --title "Phantom organ from 30 slices"

echo
echo "surface: $out/organ.stl"
echo "picture: $out/organ.png"
