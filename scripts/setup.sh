#!/usr/bin/env bash
# Install by apt what building and testing dualarm needs and this machine lacks; where nothing lacks, do nothing.
# Debian 12 or newer, as root or with sudo, without a terminal, in any locale.
set -euo pipefail
export LC_ALL=C DEBIAN_FRONTEND=noninteractive

packages=(
  build-essential cmake ninja-build ccache git ca-certificates
  libeigen3-dev libboost-dev libfcl-dev libccd-dev libompl-dev
  libgrpc++-dev libgrpc-dev libprotobuf-dev protobuf-compiler protobuf-compiler-grpc
  libcli11-dev libspdlog-dev libfmt-dev libssl-dev openssl prometheus-cpp-dev
  libgtest-dev libgmock-dev libbenchmark-dev libnlopt-cxx-dev
)

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query --show --showformat='${Status}' "$package" 2>/dev/null || true)
  [[ $status == "install ok installed" ]] || missing+=("$package")
done

if ((${#missing[@]} == 0)); then
  echo "setup: all ${#packages[@]} packages are here, nothing to install"
  exit 0
fi

as_root=()
if ((EUID != 0)); then
  if ! command -v sudo >/dev/null; then
    echo "setup: not root and no sudo; as root run: apt-get install ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300)
echo "setup: installing ${missing[*]}"
"${apt[@]}" update
"${apt[@]}" install -y --no-install-recommends "${missing[@]}"
echo "setup: installed ${#missing[@]} packages"
