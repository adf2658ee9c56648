#!/usr/bin/env bash
# Installs what TEdit is built with, from Debian 12's own packages. Does nothing when all is there.
# usage: scripts/install_deps.sh [--check-only] [--no-web | --server]
#   --no-web  without what only the client in TypeScript and its tests need (some 400 packages)
#   --server  only what server, workers and commands are built with: no window, pictures, translations, clients, tests
set -euo pipefail
check_only=no
web=yes
all=yes
for option in "$@"; do
  case "$option" in
    --check-only) check_only=yes ;;
    --no-web) web=no ;;
    --server) all=no ;;
    *) echo "unknown option $option" >&2; exit 2 ;;
  esac
done

packages=(
  # toolchain
  g++ cmake ninja-build ccache pkg-config git python3 ca-certificates
  # libraries
  libcaf-dev libboost-dev libboost-system-dev libprotobuf-dev protobuf-compiler libspdlog-dev
  libfmt-dev libcli11-dev libexpected-dev libtomlplusplus-dev libeigen3-dev libcgal-dev
  libtet1.5-dev libfreetype-dev libpugixml-dev zlib1g-dev fonts-dejavu-core libsqlite3-dev libzstd-dev libxxhash-dev nlohmann-json3-dev libssl-dev
  libseccomp-dev
  # CAD files in (the build works without)
  libocct-data-exchange-dev libocct-ocaf-dev libocct-modeling-algorithms-dev libgmsh-dev
  # MED files in and out (the build works without)
  libmedc-dev
  # Vulkan: loader, shader compiler
  libvulkan-volk-dev libvulkan-dev glslang-tools spirv-tools
  # Debian packages
  dpkg-dev file
  # the HTML manual (the build works without)
  python3-markdown
)
[ "$all" = no ] || packages+=(
  # for who works on it
  clang-format clang-tidy-16
  # Vulkan: the software device and the validation layers
  mesa-vulkan-drivers vulkan-validationlayers
  # pictures
  libvtk9-dev libgl1-mesa-dri xvfb xauth
  # the desktop client
  qt6-base-dev libqt6opengl6-dev libqt6openglwidgets6 qt6-svg-dev qt6-qpa-plugins libgl-dev
  # translations of the window (the build works without)
  qt6-l10n-tools
  # the client in Python
  python3-protobuf python3-websockets python3-numpy
  # tests
  libgtest-dev libgmock-dev librapidcheck-dev calculix-ccx poppler-utils
)
if [ "$web$all" = yesyes ]; then
  packages+=(chromium)
  # Node of another source brings npm along and does not suffer Debian's.
  command -v node >/dev/null && command -v npm >/dev/null || packages+=(nodejs npm)
fi

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing+=("$package")
done

if [ ${#missing[@]} -eq 0 ]; then
  exit 0
fi
if [ "$check_only" = yes ]; then
  echo "missing Debian packages: ${missing[*]}" >&2
  exit 1
fi

sudo=""
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || {
    echo "These Debian packages are missing: ${missing[*]}" >&2
    echo "Install them as root (apt-get install ...), then run this again." >&2
    exit 1
  }
  sudo="sudo"
fi
echo "installing ${#missing[@]} Debian packages: ${missing[*]}"
# A package list may be stale or broken for some other source of the machine: try without an update first.
install=($sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}")
log=$(mktemp)
trap 'rm -f "$log"' EXIT
if ! "${install[@]}" >"$log" 2>&1; then
  $sudo apt-get update -qq
  if ! "${install[@]}" >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    echo "apt-get could not install the packages above" >&2
    exit 1
  fi
fi
