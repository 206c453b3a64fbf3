#!/usr/bin/env bash
# cohort_overhead.sh BIN_DIR [CASES] [SNAKEMAKE OPTIONS]: what the workflow of sample_data/cohort costs beside the work.
# Reconstructs CASES (1000) tiny stacks and prints, per case, the processor time and wall time · cores of the whole run,
# those of the same reconstructions and pictures in a plain sequence of commands, and the difference.
set -euo pipefail
bin=$(cd "$1" && pwd)
count=${2:-1000}
shift $(($# > 1 ? 2 : 1))
workflow=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../sample_data/cohort" && pwd)/Snakefile
if [ -z "${DISPLAY:-}" ]; then
  exec xvfb-run -a "${BASH_SOURCE[0]}" "$bin" "$count" "$@"
fi
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
cores=2
chunk=(${CHUNK:+"chunk=$CHUNK"})  # cases in a job; by default what the workflow takes for so many

"$bin/isostack_make_phantom" sample >/dev/null
"$bin/isostack" segment sample/series --level 25 --gaussian 1 --every 6 -o tiny.json --quiet >/dev/null
options="--max-constraints 60 --resolution 15"
{
  echo id,input,options
  for ((i = 0; i < count; ++i)); do echo "case$i,$scratch/tiny.json,$options"; done
} >cases.csv

# timed LABEL COMMAND...: sets LABEL_wall and LABEL_cpu, in seconds.
timed() {
  local label=$1 wall user system
  shift
  TIMEFORMAT='%R %U %S'
  { time "$@" >out.log 2>err.log; } 2>elapsed.txt || { cat err.log; exit 1; }
  read -r wall user system <elapsed.txt
  declare -g "${label}_wall=$wall" "${label}_cpu=$(awk "BEGIN { print $user + $system }")"
}

# One program start for all: the difference between two lengths is the work alone.
work() {
  for ((i = 0; i < $1; ++i)); do
    echo "[\"reconstruct\",\"tiny.json\",\"--max-constraints\",\"60\",\"--resolution\",\"15\",\"-o\",\"a.ply\",\"--report\",\
\"r.json\",\"--record\",\"p$i.json\",\"--threads\",\"1\",\"--quiet\"]"
    echo '["view","a.ply","--screenshot","p.png","--size","480,400","--threads","1","--quiet"]'
  done | "$bin/isostack" batch
}
# shellcheck disable=SC2154 # set by timed
{
  timed short work 10
  timed long work 40
  timed all snakemake -s "$workflow" --cores "$cores" --quiet "$@" --config table=cases.csv out=results "isostack=$bin/isostack" "${chunk[@]}"
  grep -c ',done,' results/cases.csv
  awk -v n="$count" -v cores="$cores" -v wall="$all_wall" -v cpu="$all_cpu" -v w="$long_wall" -v w0="$short_wall" \
    -v c="$long_cpu" -v c0="$short_cpu" 'BEGIN {
      printf "%d cases in %.1f s on %d cores\n", n, wall, cores
      printf "per case, ms: processor time %.0f, of it work %.0f, overhead %.0f\n", 1000 * cpu / n, 1000 * (c - c0) / 30, 1000 * (cpu / n - (c - c0) / 30)
      printf "per case, ms: wall x cores %.0f, work %.0f\n", 1000 * wall * cores / n, 1000 * (w - w0) / 30 }'
}
uptime
