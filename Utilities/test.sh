#!/usr/bin/env bash
# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs what is missing, builds and runs every test:  Utilities/test.sh [ctest arguments]
# for example  Utilities/test.sh -L filters  or  Utilities/test.sh -R CtHead -V
#
# TFC_DATA_ROOT, when set, is the folder with the real volumes that the tests labelled 'data' read.
set -euo pipefail

if [[ "${1:-}" == -h || "${1:-}" == --help ]]; then
  sed -n '5,8s/^# \{0,1\}//p' "$0"
  exit 0
fi
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
jobs=$(nproc)

"$root/Utilities/install-dependencies.sh" build test

options=(-DTFC_BUILD_TESTING=ON)
if [[ -n "${TFC_DATA_ROOT:-}" ]]; then
  if [[ ! -d "$TFC_DATA_ROOT" ]]; then
    echo "test.sh: TFC_DATA_ROOT is '$TFC_DATA_ROOT', which is not a folder" >&2
    exit 1
  fi
  options+=(-DTFC_DATA_ROOT="$(cd "$TFC_DATA_ROOT" && pwd)")
fi

# Another Python's variables would hide ParaView's modules.
unset PYTHONHOME PYTHONPATH
echo "== Configuring"
(cd "$root" && cmake --preset dev "${options[@]}")
echo "== Building"
cmake --build "$root/build" --parallel "$jobs"

# More processes than cores: let those that wait yield, and the software renderer not take them all.
export OMPI_MCA_mpi_yield_when_idle=${OMPI_MCA_mpi_yield_when_idle:-1}
export LP_NUM_THREADS=${LP_NUM_THREADS:-2}
display=()
if [[ -z "${DISPLAY:-}" ]]; then
  # -noreset: else the server restarts whenever a test closes the last connection, and the next
  # test may find it gone.
  display=(xvfb-run -a -s "-screen 0 1600x1200x24 -noreset")
fi
echo "== Testing"
cd "$root/build"
"${display[@]}" ctest --output-on-failure --parallel "$jobs" "$@"
