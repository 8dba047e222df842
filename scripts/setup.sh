#!/usr/bin/env bash
# Installs with apt what tremolo needs and this machine lacks. Made for Debian 12; as root or through sudo; does nothing
# when everything is there.
#
#   scripts/setup.sh         what building, running, plotting and testing need
#   scripts/setup.sh lint    what scripts/lint.sh needs besides
set -euo pipefail

packages=(
  build-essential cmake ninja-build pkg-config git ccache
  libeigen3-dev libfftw3-dev libgsl-dev libsundials-dev              # mathematics
  libopenmpi-dev openmpi-bin                                         # ranks that share a domain
  libzmq3-dev cppzmq-dev nlohmann-json3-dev zlib1g-dev               # exchange between processes
  libhdf5-dev                                                        # results
  libtomlplusplus-dev libcli11-dev libfmt-dev                        # case file, command line, messages
  python3 python3-numpy python3-h5py python3-matplotlib python3-zmq  # plots, free fields in Python
  python3-jinja2 python3-plotly                                      # reports
  chromium chromium-driver python3-selenium                          # tests of reports
  zsh fish groff-base python3-pip python3-setuptools dpkg-dev file    # tests of the installation
  slurm-wlm munge                                                    # tests of sweeps
  mkdocs mkdocs-material                                             # the documentation as a site
  libgtest-dev libgmock-dev libbenchmark-dev librapidcheck-dev python3-vtk9 iproute2 valgrind   # tests
)
case "${1:-}" in
  "") ;;
  lint) packages=(git clang-format clang-tidy) ;;
  *) echo "setup: unknown argument '$1' (nothing, or lint)" >&2; exit 2 ;;
esac

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
  echo "setup: all ${#packages[@]} packages are installed, nothing to do"
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo > /dev/null; then
    echo "setup: neither root nor sudo; ask an administrator for: apt-get install ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
echo "setup: installs with apt-get: ${missing[*]}"
"${as_root[@]}" apt-get update -q || echo "setup: apt-get update failed, trying with the package lists at hand" >&2
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"
echo "setup: done"
