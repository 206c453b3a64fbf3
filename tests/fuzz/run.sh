#!/usr/bin/env bash
# Runs each fuzzer for SECONDS, or those named behind it; exits with 1 when one of them found something.
# Usage: tests/fuzz/run.sh SECONDS [FORMAT...]      (builds the preset fuzz first; ISOSTACK_FUZZ_BUILD: a folder built)
# New inputs and findings are kept in BUILD/fuzz/<format> and BUILD/fuzz/findings.
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
seconds=${1:?usage: tests/fuzz/run.sh SECONDS [FORMAT...]}
shift

build=${ISOSTACK_FUZZ_BUILD:-$top/build/fuzz}
if [ -z "${ISOSTACK_FUZZ_BUILD:-}" ]; then
  cd "$top"
  cmake --preset fuzz
  cmake --build --preset fuzz
fi

corpus=$build/fuzz
mkdir -p "$corpus/findings"
"$build/bin/fuzz_seeds" "$corpus"
formats=("$@")
[ ${#formats[@]} -gt 0 ] || for folder in "$corpus"/*/; do
  format=$(basename "$folder")
  [ "$format" = findings ] || formats+=("$format")
done

# Leaks are GDCM's own when it throws; memory is bounded by -rss_limit_mb.
export ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=0 UBSAN_OPTIONS=print_stacktrace=1
failed=()
for format in "${formats[@]}"; do
  "$build/bin/${format}_fuzz" -max_total_time="$seconds" -max_len=16384 -timeout=10 -rss_limit_mb=2048 \
    -malloc_limit_mb=1024 -seed=1 -use_value_profile=1 -print_final_stats=1 -artifact_prefix="$corpus/findings/$format-" "$corpus/$format" \
    >"$corpus/$format.log" 2>&1 || failed+=("$format")
  echo "$format: $(sed -n 's/^stat::number_of_executed_units: *//p' "$corpus/$format.log") inputs"
done
[ ${#failed[@]} -eq 0 ] && exit 0
for format in "${failed[@]}"; do
  echo "== finding: $format" >&2
  grep -v '^#[0-9]*.*\(NEW\|REDUCE\|RELOAD\|pulse\)' "$corpus/$format.log" | tail -60 >&2
done
exit 1
