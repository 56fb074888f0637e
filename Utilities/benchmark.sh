#!/usr/bin/env bash
# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds, runs the benchmarks and writes Testing/Benchmarks/RESULTS.md.
set -euo pipefail

usage() {
  cat <<'TEXT'
usage: Utilities/benchmark.sh [NAME [ARGUMENTS]]

Runs the benchmark NAME, or all of them: advice, attributes, editor, volume. Its table goes to the
terminal and to its section of Testing/Benchmarks/RESULTS.md. Exit status 1: a ratio is above its
limit.

  --repeats N     how often each is measured; the median counts (default 5; volume: 9 frames)
  --only "A;B"    only the named rows of the table
  --output FILE   another file than RESULTS.md

Needs what Utilities/install-dependencies.sh installs for the groups build and benchmark; a peer
that is not installed is named as missing.
TEXT
}

source_dir="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
build_dir="${TFC_BUILD_DIR:-$source_dir/build}"
names=(advice attributes editor volume)
if (($# > 0)); then
  case "$1" in
    -h | --help)
      usage
      exit 0
      ;;
    advice | attributes | editor | volume)
      names=("$1")
      shift
      ;;
    *)
      echo "benchmark.sh: unknown benchmark '$1'" >&2
      usage >&2
      exit 2
      ;;
  esac
fi

"$source_dir/Utilities/install-dependencies.sh" build
cmake -S "$source_dir" -B "$build_dir" -G Ninja -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build "$build_dir"
cmake -S "$source_dir/Testing/Benchmarks" -B "$build_dir/benchmarks" -G Ninja >/dev/null
cmake --build "$build_dir/benchmarks"

export PYTHONPATH="$build_dir/lib/python3/dist-packages:$source_dir/Testing/Benchmarks"
status=0
for name in "${names[@]}"; do
  run=(pvpython)
  if [[ ("$name" == volume || "$name" == editor) && -z "${DISPLAY:-}" ]]; then
    run=(xvfb-run -a -s "-screen 0 1600x1200x24 -noreset" pvpython)
  fi
  "${run[@]}" "$source_dir/Testing/Benchmarks/$name.py" "$build_dir/benchmarks/tfc_peers" \
    --output "$source_dir/Testing/Benchmarks/RESULTS.md" "$@" || status=1
done
exit "$status"
