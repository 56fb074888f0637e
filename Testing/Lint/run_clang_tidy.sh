#!/bin/sh
# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
#
# clang-tidy 14 over the project's C++ with the project's .clang-tidy. Too slow for ctest.
#
#     Testing/Lint/run_clang_tidy.sh [BUILD_FOLDER [REGULAR_EXPRESSION]]
#
# The build folder (default: build) must be configured and built, for generated headers. The regular
# expression chooses files by their path below the root, for example 'Rendering/Volume/.*'.
# Ends with an error when there are findings.
set -eu

root=$(cd "$(dirname "$0")/../.." && pwd)
build=${1:-$root/build}
files=${2:-(Filters|Rendering|Plugin|Testing)/.*}

if [ ! -f "$build/compile_commands.json" ]; then
  echo "$build/compile_commands.json does not exist: configure first (cmake --preset dev)" >&2
  exit 2
fi
for program in run-clang-tidy-14 clang-tidy-14; do
  if ! command -v "$program" >/dev/null; then
    echo "$program was not found: install it (Debian: clang-tidy-14)" >&2
    exit 2
  fi
done
if ! grep -Eq "\"file\": \"$root/$files\\.cxx\"" "$build/compile_commands.json"; then
  echo "no source matches $files (from the root on, without the ending .cxx)" >&2
  exit 2
fi
exec run-clang-tidy-14 -clang-tidy-binary "$(command -v clang-tidy-14)" -quiet \
  -j "${JOBS:-$(nproc)}" -p "$build" "^$root/$files\\.cxx\$"
