# Sourced by demo and check: installs missing packages, configures and builds; quiet unless something fails.

isocast_packages=(g++ cmake ninja-build ccache libtbb-dev libfmt-dev libcli11-dev nlohmann-json3-dev
  libsleef-dev libembree-dev libopenimageio-dev libnifti2-dev libopenvdb-dev libnanovdb-dev libblosc-dev libboost-dev libimath-dev libpugixml-dev zlib1g-dev pkg-config catch2 libgmp-dev libmpfr-dev
  libflint-dev libflint-arb-dev libeigen3-dev libglfw3-dev libimgui-dev libstb-dev libgl-dev libx11-dev libxtst-dev
  fonts-dejavu-core)
# What only tests need: a screen in memory.
isocast_test_packages=(xvfb xauth libgl1-mesa-dri)

# Runs a command; shows what it printed only when it fails.
quietly() {
  local log status=0
  log=$(mktemp)
  "$@" >"$log" 2>&1 || status=$?
  if ((status)); then cat "$log" >&2; fi
  rm -f "$log"
  return "$status"
}

# The packages of the list that dpkg does not report as installed, one a line.
missing_packages() {
  local package
  for package in "${isocast_packages[@]}"; do
    [[ $(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) == installed* ]] || echo "$package"
  done
}

install_packages() {
  local missing as_root=()
  mapfile -t missing < <(missing_packages)
  ((${#missing[@]})) || return 0
  if ! command -v apt-get >/dev/null || { ((EUID)) && ! command -v sudo >/dev/null; }; then
    echo "isocast: packages are missing that only Debian's apt-get as root or with sudo can install:" \
      "${missing[*]}" >&2
    exit 2
  fi
  ((EUID)) && as_root=(sudo)
  echo "Installing ${missing[*]}"
  # an update that fails for one foreign source does not matter when the installation succeeds
  local script="apt-get update; apt-get install -y --no-install-recommends -o DPkg::Lock::Timeout=300"
  quietly "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive sh -c "$script ${missing[*]}"
}

# One job a core, as long as each has 1.5 GB of memory.
job_count() {
  local cores memory_kb jobs
  cores=$(nproc)
  memory_kb=$(awk '/^MemTotal:/ {print $2}' /proc/meminfo)
  jobs=$((memory_kb / 1500000))
  echo $((jobs < 1 ? 1 : jobs < cores ? jobs : cores))
}

# build PRESET FOLDER [TARGET...]: everything without targets; configures only the first time and after a
# change of the presets.
build() {
  local preset=$1 folder=$2 targets=()
  shift 2
  (($#)) && targets=(--target "$@")
  if [[ ! -f $folder/build.ninja || CMakePresets.json -nt $folder/build.ninja ]]; then
    echo "Configuring $folder"
    quietly cmake --preset "$preset"
  fi
  echo "Building in $folder"
  quietly cmake --build --preset "$preset" --parallel "$(job_count)" "${targets[@]}"
}
