#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test through ctest. Arguments go to ctest.
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$top"

cmake/install-packages.sh
preset=release
[ "${CI:-}" = true ] && preset=ci
cmake --preset "$preset" -DISOSTACK_BUILD_TESTS=ON
cmake --build --preset "$preset"
exec xvfb-run -a -s '-screen 0 1600x1200x24' ctest --preset "$preset" --no-tests=error -j2 "$@"
