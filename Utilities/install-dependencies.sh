#!/usr/bin/env bash
# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs the Debian packages that this project needs and that are missing, as root or with sudo.
# Quick, and without touching the network, when nothing is missing.
set -euo pipefail

usage() {
  cat <<'TEXT'
usage: Utilities/install-dependencies.sh [build] [test] [render] [demo] [benchmark]

Installs what is missing of the Debian 12 packages for the named groups, by default for build, test
and demo:
  build   compiler, ParaView and the libraries that its CMake files look for
  test    GoogleTest, NumPy, SciPy, clang-format and a virtual X server
  render  NumPy and a virtual X server
  demo    the same and the CT head of the package invesalius-examples
  benchmark  the peers of the benchmarks: SciPy, scikit-image and ITK (700 MB)
TEXT
}

build_packages=(
  g++ cmake ninja-build git ca-certificates
  paraview paraview-dev python3-paraview python3-dev
  # paraview-dev does not depend on these, but its CMake files look for them.
  qtbase5-dev libqt5svg5-dev libqt5opengl5-dev qttools5-dev qtxmlpatterns5-dev-tools
  libhdf5-dev libxml2-dev libutfcpp-dev libogg-dev libtheora-dev
  libavformat-dev libavcodec-dev libavutil-dev libswscale-dev
  libgl2ps-dev libpng-dev libnetcdf-dev libgdal-dev libopenmpi-dev openmpi-bin
  libglew-dev libdouble-conversion-dev libfreetype-dev
)
# ParaView's X11 build needs an X server even to render off screen.
render_packages=(python3-numpy xvfb xauth libgl1-mesa-dri)
test_packages=(libgtest-dev python3-scipy clang-format "${render_packages[@]}")
demo_packages=(invesalius-examples "${render_packages[@]}")
benchmark_packages=(python3-numpy python3-scipy python3-skimage libinsighttoolkit5-dev)
ct_head=/usr/share/doc/invesalius-examples/examples/Cranium.inv3

packages=()
demo=0
if (($# == 0)); then
  set -- build test demo
fi
for group in "$@"; do
  case "$group" in
    build) packages+=("${build_packages[@]}") ;;
    test) packages+=("${test_packages[@]}") ;;
    render) packages+=("${render_packages[@]}") ;;
    benchmark) packages+=("${benchmark_packages[@]}") ;;
    demo)
      packages+=("${demo_packages[@]}")
      demo=1
      ;;
    -h | --help)
      usage
      exit 0
      ;;
    *)
      echo "install-dependencies.sh: unknown group '$group'" >&2
      usage >&2
      exit 2
      ;;
  esac
done

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "install-dependencies.sh: this is not a Debian system; install the equivalents of:" >&2
  printf '  %s\n' "${packages[@]}" | sort -u >&2
  exit 1
fi

installed() {
  [[ "$(dpkg-query -W -f='${db:Status-Abbrev}' "$1" 2>/dev/null)" == ii* ]]
}

missing=()
for package in "${packages[@]}"; do
  if ! installed "$package" && [[ " ${missing[*]:-} " != *" $package "* ]]; then
    missing+=("$package")
  fi
done
# Slim images leave /usr/share/doc out when they install a package.
unpack_ct_head=0
if ((demo)) && [[ ! -e "$ct_head" ]]; then
  unpack_ct_head=1
fi

if ((${#missing[@]} == 0 && !unpack_ct_head)); then
  echo "== Dependencies: everything is installed"
  exit 0
fi

as_root=()
if ((EUID != 0)); then
  if ! command -v sudo >/dev/null; then
    echo "install-dependencies.sh: run this as root, or install sudo. Missing packages:" >&2
    printf '  %s\n' "${missing[@]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
apt_install() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install \
    --yes --quiet --no-install-recommends -o Dpkg::Use-Pty=0 "$@"
}

echo "== Dependencies: updating the package lists"
"${as_root[@]}" apt-get update --quiet

if ((${#missing[@]})); then
  echo "== Dependencies: installing ${missing[*]}"
  apt_install "${missing[@]}"
fi
if ((demo)) && [[ ! -e "$ct_head" ]]; then
  echo "== Dependencies: unpacking the CT head, which this system's dpkg configuration left out"
  apt_install --reinstall invesalius-examples \
    -o DPkg::Options::="--path-include=/usr/share/doc/invesalius-examples*"
fi
echo "== Dependencies: done"
