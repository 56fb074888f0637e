#!/usr/bin/env bash
# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs what is missing, builds, and renders a CT head, or the user's own volume.
set -euo pipefail

usage() {
  cat <<'TEXT'
usage: Utilities/demo.sh [OUTPUT_DIR] [--gui]
       Utilities/demo.sh [OUTPUT_DIR] --data FILE --state FILE.tfc.json
                         [--radius N] [--eta X] [--gui]

Installs what is missing, builds the plugin, and leaves pictures and states in OUTPUT_DIR
(./output).

Without --data: prints which attribute of a CT head suits best as tertiary attribute, and renders
skull, skin and brain with a 2D transfer function alone (ct_head_2d.png) and combined with the
occlusion (ct_head_combined.png).

  --data FILE     render this volume instead, an image in any format that ParaView opens
  --state FILE    with this transfer function; arrays called <array>_gradient and <array>_occlusion
                  are computed where the file does not have them
  --radius N      radius of the occlusion in voxels (40); the CT head's states need 15
  --eta X         boundary parameter of the occlusion (0.005); the CT head's states need 1
  --gui           then open ParaView with the plugin and the state that was rendered last
TEXT
}

misuse() {
  echo "demo.sh: $1" >&2
  usage >&2
  exit 2
}

output=
data=
state=
gui=0
occlusion=()
while (($#)); do
  case "$1" in
    -h | --help)
      usage
      exit 0
      ;;
    --gui) gui=1 ;;
    --data | --state | --radius | --eta)
      if (($# < 2)) || [[ -z "$2" ]]; then
        misuse "$1 needs a value"
      fi
      case "$1" in
        --data) data=$2 ;;
        --state) state=$2 ;;
        --radius)
          [[ "$2" =~ ^[1-9][0-9]*$ ]] || misuse "--radius needs a whole number above 0, not '$2'"
          occlusion+=("$1" "$2")
          ;;
        --eta)
          [[ "$2" =~ ^[0-9]*\.?[0-9]+(e-?[0-9]+)?$ ]] || misuse "--eta needs a number, not '$2'"
          occlusion+=("$1" "$2")
          ;;
      esac
      shift
      ;;
    -*) misuse "unknown option '$1'" ;;
    *)
      [[ -n "$1" && -z "$output" ]] || misuse "unexpected argument '$1'"
      output=$1
      ;;
  esac
  shift
done
[[ -z "$data" || -n "$state" ]] || misuse "--data needs --state"
[[ -z "$state" || -n "$data" ]] || misuse "--state needs --data"
[[ -n "$data" || ${#occlusion[@]} -eq 0 ]] || misuse "--radius and --eta need --data"
for file in "$data" "$state"; do
  if [[ -n "$file" && ! -f "$file" ]]; then
    echo "demo.sh: $file: no such file" >&2
    exit 1
  fi
done
if ((gui)) && [[ -z "${DISPLAY:-}" ]]; then
  echo "demo.sh: --gui needs an X display; set DISPLAY" >&2
  exit 1
fi

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
mkdir -p "${output:=output}"
output=$(cd "$output" && pwd)

# Another Python's variables would hide ParaView's modules.
unset PYTHONHOME PYTHONPATH
if [[ -n "$data" ]]; then
  "$root/Utilities/install-dependencies.sh" build render
else
  "$root/Utilities/install-dependencies.sh" build demo
fi

# A build folder that is there keeps its options: a developer's tests stay configured.
if [[ ! -e "$root/build/build.ninja" ]]; then
  echo "== Configuring"
  (cd "$root" && cmake --preset dev -DTFC_BUILD_TESTING=OFF)
fi
echo "== Building"
cmake --build "$root/build" --parallel "$(nproc)"

plugin=$(find "$root/build" -path '*/plugins/*' -name TransferFunctionCombinations.so -print -quit)
if [[ -z "$plugin" ]]; then
  echo "demo.sh: the build has left no plugin in $root/build" >&2
  exit 1
fi
# The folder of the plugins holds one folder for each.
PV_PLUGIN_PATH=$(dirname "$(dirname "$plugin")")
package=$(find "$root/build" -path '*/tfc/__init__.py' -print -quit)
PYTHONPATH=$(dirname "$(dirname "$package")")
export PV_PLUGIN_PATH PYTHONPATH

display=()
if [[ -z "${DISPLAY:-}" ]]; then
  # -noreset: else the server restarts, and is gone for a moment, when the first connection closes.
  display=(xvfb-run -a -s "-screen 0 1600x1200x24 -noreset")
fi
examples="$root/Plugin/Examples"
if [[ -n "$data" ]]; then
  echo "== Rendering $data"
  "${display[@]}" pvpython --force-offscreen-rendering "$examples/render_volume.py" \
    "$data" "$state" "$output" "${occlusion[@]}"
  name=$(basename "$data")
  pvsm="$output/${name%.*}.pvsm"
else
  echo "== Rendering the CT head"
  "${display[@]}" pvpython --force-offscreen-rendering "$examples/ct_head.py" "$output"
  pvsm="$output/ct_head.pvsm"
fi
echo "== Done: pictures and states are in $output"

if ((gui)); then
  echo "== Opening ParaView; where it shows its welcome window, close that to see the volume"
  exec paraview --plugins=TransferFunctionCombinations --state="$pvsm"
fi
