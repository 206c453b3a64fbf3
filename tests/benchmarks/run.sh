#!/usr/bin/env bash
# run.sh [--build DIR] [--list] [CASE...]: builds the benchmarks, runs the cases named (all of them without a name), each
# in a process of its own, and prints one markdown table. A unit is LAPACK's dsysv for 10,000 constraints, measured
# just before each case. Rivals whose Debian package is missing are skipped with a sentence.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
top=$(cd "$here/../.." && pwd)
build=$top/build/release
# name | asked: units, GB, residual | command
cases='
r-47k            |     |     | 1e-5 | solve_star_stack biharmonic 31 1e-5
r-239k           | 2   | 0.8 | 1e-5 | solve_star_stack biharmonic 156 1e-5
r-478k           |     |     | 1e-5 | solve_star_stack biharmonic 313 1e-5
r-956k           | 11  | 2.5 | 1e-5 | solve_star_stack biharmonic 626 1e-5
r3-239k          | 2.5 | 1   | 3e-4 | solve_star_stack triharmonic 156 3e-4
r3-956k          | 20  | 3.5 | 1e-3 | solve_star_stack triharmonic 626 1e-3
r3-4D-50k        | 1.5 |     | 1e-5 | solve_morph 12500 1e-5
evaluate-956k    |     |     | 1e-5 | evaluate_star_stack 626 1000000
surface-239k     |     |     | 1e-3 | surface_star_stack 156 2
r-10k            |     |     | 1e-5 | solve_star_stack biharmonic 7 1e-5 10000
rival-scipy-10k  |     |     |      | rival_scipy.py 10000
pipeline-200k    |     |     | 1e-3 | surface_star_stack 262 2
rival-cgal-200k  |     |     |      | rival_cgal_poisson 262 MESH
rival-pcl-200k   |     |     |      | rival_pcl_poisson 262 MESH
read-300         |     |     |      | read_series SERIES
rival-gdcm-300   |     |     |      | rival_gdcm_read SERIES
'

wanted=()
while [ $# -gt 0 ]; do
  case $1 in
    --build) build=$(mkdir -p "$2" && cd "$2" && pwd) && shift ;;
    --list) awk -F'|' 'NF > 1 { gsub(/ /, "", $1); print $1 }' <<<"$cases" && exit 0 ;;
    -*) echo "usage: run.sh [--build DIR] [--list] [CASE...]" >&2 && exit 2 ;;
    *) wanted+=("$1") ;;
  esac
  shift
done

[ -f "$build/CMakeCache.txt" ] || cmake -S "$top" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build "$build" --target benchmarks >&2
bin=$build/bin
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
skipped=()

trim() { local text=$1; text=${text#"${text%%[![:space:]]*}"}; echo "${text%"${text##*[![:space:]]}"}"; }
value_of() { sed -n "s/^$1 //p" <<<"$2" | head -n 1; }
# asked FIGURE LIMIT: "FIGURE (≤ LIMIT)", and whether it was missed.
asked() {
  [ -n "$1" ] || { echo "–" && return; }
  [ -n "$2" ] || { echo "$1" && return; }
  awk -v a="$1" -v b="$2" 'BEGIN { printf "%s (≤ %s%s)", a, b, a + 0 <= b + 0 ? "" : ", missed" }'
}
is_missing() {
  case $1 in
    rival_scipy.py) ! /usr/bin/python3 -c 'import scipy.interpolate' 2>/dev/null ;;
    *) [ ! -x "$bin/$1" ] ;;
  esac
}
program_of() { case $1 in *.py) echo "/usr/bin/python3 $here/$1" ;; *) echo "$bin/$1" ;; esac }

# run_case NAME UNITS GB RESIDUAL COMMAND...: one row of the table.
run_case() {
  local name=$1 units_asked=$2 memory_asked=$3 residual_asked=$4 program=$5
  shift 5
  if is_missing "$program"; then
    case $program in
      *scipy*) skipped+=("$name was skipped: install python3-scipy.") ;;
      *cgal*) skipped+=("$name was skipped: install libcgal-dev.") ;;
      *pcl*) skipped+=("$name was skipped: install libpcl-dev.") ;;
      *) echo "$program was not built" >&2 && exit 1 ;;
    esac
    return
  fi
  local unit output status=0 units
  unit=$(value_of seconds "$("$bin/dsysv_unit")")
  if [ "${1:-}" = SERIES ]; then  # 300 slices of 512 x 512 pixels of 16 bits, 160 MB
    [ -d "$scratch/series" ] || "$bin/read_series" --make "$scratch/series" 300
    set -- "$scratch/series"
  fi
  # Interpreter and program are two words.
  # shellcheck disable=SC2046
  output=$($(program_of "$program") "${@/#MESH/$scratch/$name.ply}" 2>"$scratch/errors") || status=$?
  if [ -s "$scratch/$name.ply" ]; then
    output+=$'\n'$("$bin/distance_to_star_stack" "$scratch/$name.ply" "$1")
  fi
  [ $status -eq 0 ] || output+=$'\n'"remark failed with exit code $status: $(tail -n 1 "$scratch/errors")"
  units=$(awk -v s="$(value_of seconds "$output")" -v u="$unit" 'BEGIN { if (s > 0) printf "%.2f", s / u }')
  echo "| $name | $(value_of constraints "$output") | $(value_of seconds "$output") | $unit |" \
    "$(asked "$units" "$units_asked") | $(asked "$(value_of residual "$output")" "$residual_asked") |" \
    "$(value_of iterations "$output") | $(asked "$(value_of peak_gb "$output")" "$memory_asked") |" \
    "$(value_of remark "$output") |"
}

echo "$(nproc) cores, $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1); $(value_of blas "$("$bin/dsysv_unit")")"
echo
echo "| case | constraints | time, s | unit, s | units (asked) | residual (asked) | iterations | peak, GB (asked) | remark |"
echo "| --- | --- | --- | --- | --- | --- | --- | --- | --- |"
while IFS='|' read -r name units memory residual command; do
  name=$(trim "$name")
  [ -n "$name" ] || continue
  if [ ${#wanted[@]} -gt 0 ] && [[ " ${wanted[*]} " != *" $name "* ]]; then continue; fi
  read -ra words <<<"$command"
  run_case "$name" "$(trim "$units")" "$(trim "$memory")" "$(trim "$residual")" "${words[@]}"
done <<<"$cases"
[ ${#skipped[@]} -eq 0 ] || printf '\n%s\n' "${skipped[@]}"
