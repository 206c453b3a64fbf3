#!/usr/bin/env bash
# run_examples.sh BIN_DIR: runs every example of docs/commands.md, docs/morphing.md, docs/blending.md and
# docs/viewing.md, and those of docs/level-set-morphing.md, docs/distance.md and docs/getting-started.md that need nothing
# but the sample, in their order, in a scratch folder. Fails at the first that fails.
set -euo pipefail
docs=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../docs" && pwd)
bin=$1
export PATH="$bin:$PATH" bin
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

isostack_make_phantom sample
isostack_make_shapes sample/shapes
isostack_make_key_shapes sample/keys
count=0
while IFS= read -r line; do
  [ -n "${DISPLAY:-}" ] && line=${line/xvfb-run /}
  echo "+ $line"
  eval "$line" >/dev/null
  count=$((count + 1))
done < <(sed -n 's/^    \(\(xvfb-run \)\?isostack .*\)$/\1/p' "$docs/commands.md" "$docs/morphing.md" "$docs/blending.md" "$docs/subdivision.md" \
    "$docs/viewing.md" "$docs/pipelines.md" "$docs/results.md"
  sed -n 's/^    \(\(xvfb-run \)\?isostack [a-z]* sample.*\)$/\1/p' "$docs/distance.md" "$docs/level-set-morphing.md"
  sed -n 's/^    \(\$bin\/isostack .*sample.*\)$/\1/p' "$docs/getting-started.md")
echo "$count examples ran"
[ "$count" -ge 8 ]
