# shellcheck shell=bash disable=SC2034
# For run-tests and run-demo, which source it: what a fresh Debian or Ubuntu machine lacks is installed here.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# what every build of Spider needs
build_packages=(g++ make cmake libcgal-dev libeigen3-dev libtbb-dev)

# what the program spider needs beyond that, and what the comparison harness needs beyond both: to build, and to make the
# report
tool_packages=(libcli11-dev nlohmann-json3-dev)
harness_packages=(libbenchmark-dev)
report_packages=(python3-jinja2 python3-matplotlib python3-numpy python3-vtk9 xvfb xauth)

fail() {
  echo "$(basename "$0"): $*" >&2
  exit 1
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    fail "needs to be root, or to have sudo, to run: $*"
  fi
}

is_installed() {
  [ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# install_packages package...: those that are missing; asks for nothing and does nothing where all are there.
install_packages() {
  command -v apt-get >/dev/null || fail "sets up Debian and Ubuntu only; elsewhere provide yourself: $*"
  local package missing=()
  for package in "$@"; do
    is_installed "$package" || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return
  echo "== installing ${missing[*]}"
  as_root apt-get update --quiet
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install --yes --quiet --no-install-recommends "${missing[@]}"
}

# install_chromium: one test needs it, and says so where it is skipped. Ubuntu's package is a stub that asks for a snap,
# which containers cannot have, so it is left alone.
install_chromium() {
  local about
  about=$(apt-cache show chromium 2>/dev/null || true)
  if [ -z "$about" ] || [[ "${about,,}" == *snap* ]]; then
    echo "== no package of Chromium: unless there is one already, the test that opens the report in it will be skipped"
  else
    install_packages chromium
  fi
}

# install_meshes: CGAL's example meshes, and prints the CMake option that says where their archive is. Minimal images tell
# dpkg to leave documentation out, and the archive counts as such: then it is taken straight from the package.
install_meshes() {
  local archive=/usr/share/doc/libcgal-dev/data.tar.gz
  install_packages libcgal-demo >&2
  if [ ! -e "$archive" ]; then
    local kept=$root/build/libcgal-demo
    archive=$kept/usr/share/doc/libcgal-dev/data.tar.gz
    if [ ! -e "$archive" ]; then
      mkdir -p "$kept"
      (cd "$kept" && apt-get download --quiet libcgal-demo && dpkg-deb --extract libcgal-demo_*.deb .) >&2
    fi
  fi
  echo "-DSPIDER_DATA_ARCHIVE=$archive"
}

# build_spider directory target... -- option...: configures the release preset there and builds the targets.
build_spider() {
  local directory=$1 targets=()
  shift
  while [ "$1" != -- ]; do
    targets+=("$1")
    shift
  done
  shift
  echo "== building in $directory"
  (cd "$root" && cmake --preset release -B "$directory" "$@")
  cmake --build "$directory" --parallel "$(nproc)" --target "${targets[@]}"
}

# on_screen command...: with the user's display, or a virtual one where there is none.
on_screen() {
  if [ -n "${DISPLAY-}" ]; then
    "$@"
  else
    xvfb-run --auto-servernum "$@"
  fi
}
