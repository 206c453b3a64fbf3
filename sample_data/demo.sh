#!/usr/bin/env bash
# demo.sh [OUT_DIR]: installs what is missing, builds, and runs the main job on the generated sample (isostack_demo).
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=$(realpath -m "${1:-$top/build/demo}")
cd "$top"

cmake/install-packages.sh
cmake --preset release -DISOSTACK_BUILD_TESTS=OFF
cmake --build --preset release
PATH=$top/build/release/bin:$PATH exec sample_data/isostack_demo "$out"
