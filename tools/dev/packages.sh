# SPDX-License-Identifier: MIT
# shellcheck shell=dash
# The Debian packages that are needed, and installing them. Part of ./dev, which has set $root.

fly_packages="g++ cmake ninja-build libeigen3-dev libtomlplusplus-dev libcli11-dev libfmt-dev nlohmann-json3-dev libmd-dev liblcm-dev liblcm-bin libcpp-httplib-dev libzip-dev libpugixml-dev"
can_packages="user-mode-linux busybox-static can-utils iproute2"
# Debian 13 has the linker gold, which the trials of mutants ask for, in a package of its own.
gold_packages=""
# shellcheck disable=SC1091
[ "$(. /etc/os-release 2>/dev/null && echo "${VERSION_ID:-}")" != 13 ] || gold_packages=binutils-gold
test_packages="$fly_packages $can_packages $gold_packages libgtest-dev libgmock-dev librapidcheck-dev mandoc python3-venv python3-dev"
firmware_packages="gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib libeigen3-dev cmake ninja-build git python3"
arm_packages="$firmware_packages qemu-system-arm googletest"
board_packages="$test_packages $firmware_packages libunicorn-dev"
flash_packages="openocd stlink-tools dfu-util stm32flash"
format_packages="clang-format-19"
gate_packages="$test_packages clang-19 clang-tidy-19"
coverage_packages="$test_packages clang-19 llvm-19 libclang-rt-19-dev"
mutation_packages="$test_packages python3-clang-19 libclang-common-19-dev"
soak_packages="$test_packages clang-19 libclang-rt-19-dev"
bench_packages="$fly_packages libbenchmark-dev libceres-dev python3-venv"
browser_packages="chromium chromium-driver poppler-utils"
playground_packages="$fly_packages clang-19 lld-19 libc++-19-dev-wasm32 libc++abi-19-dev-wasm32 libclang-rt-19-dev-wasm32 wasi-libc"
docs_packages="$fly_packages $can_packages doxygen chromium chromium-driver python3-venv"
package_packages="$fly_packages $firmware_packages dpkg-dev file"
shell_packages="zsh fish"
cluster_packages="slurmctld slurmd slurm-client munge"
# With --all no test may be skipped, and the tests call the verbs of this script, except those that take hours.
all_packages="$test_packages $arm_packages $board_packages $gate_packages $coverage_packages $mutation_packages $format_packages $cluster_packages $browser_packages $playground_packages $shell_packages locales nodejs"

system_name() {
  # shellcheck disable=SC1091
  (. /etc/os-release 2>/dev/null && echo "${PRETTY_NAME:-this system}") || echo "this system"
}

is_installed() {
  dpkg-query -W -f '${Status}' "$1" 2>/dev/null | grep -q 'install ok installed'
}

# refuse TEXT...: prints the message and exits with the code for something missing.
refuse() {
  printf 'dev: %s\n' "$@" >&2
  exit 69
}

# need PACKAGE...: asks dpkg about each, and touches the network only when one is missing.
need() {
  command -v dpkg-query >/dev/null ||
    refuse "$(system_name) has no dpkg, and this script knows only the packages of Debian 12. Install the equivalents of" \
      "  $*" "and build with: cmake --preset host && cmake --build --preset host"
  missing=""
  for package in "$@"; do
    is_installed "$package" || case " $missing " in *" $package "*) ;; *) missing="$missing $package" ;; esac
  done
  [ -n "$missing" ] || return 0
  as_root=""
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || refuse "this user is not root, and there is no sudo. Run this as root, then try again:" \
      "  apt-get update && apt-get install --no-install-recommends$missing"
    as_root="sudo"
  fi
  echo "dev: installing$missing" >&2
  install_packages
}

# apt without questions; waits for other package managers.
apt() {
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=600 "$@" >&2
}

install_packages() {
  interrupted=$(dpkg --audit 2>/dev/null)
  [ -z "$interrupted" ] || refuse "an earlier installation was interrupted; as root:" \
    "  dpkg --configure -a && apt-get --fix-broken install" "and then this command again. The message of dpkg:" "$interrupted"
  if [ -n "$as_root" ] && ! sudo true; then
    refuse "sudo did not let this user run it. Run this as root, then try again:" \
      "  apt-get update && apt-get install --no-install-recommends$missing"
  fi
  reached=yes
  apt -o APT::Update::Error-Mode=any update || reached=""
  unknown=""
  for package in $missing; do
    LC_ALL=C apt-cache policy "$package" 2>/dev/null | grep -q 'Candidate: [^(]' || unknown="$unknown $package"
  done
  if [ -n "$unknown" ] && [ -z "$reached" ]; then
    refuse "the package servers could not be reached (see above), and without them these are unknown:$unknown" \
      "Check the network, and the proxy if you need one, then run this command again."
  fi
  [ -z "$unknown" ] || refuse "$(system_name) has no package$unknown; Fantail is built and tested on Debian 12." \
    "Install what is available by hand; the build then names what is still missing:" \
    "  cmake --preset host && cmake --build --preset host"
  # shellcheck disable=SC2086 # a list of words
  apt -y --no-install-recommends install $missing && return 0
  free_mb=$(df -Pm /var/cache/apt / 2>/dev/null | awk 'NR > 1 && (least == "" || $4 < least) { least = $4 } END { print least }')
  [ -n "$reached" ] || refuse "the packages could not be fetched: the package servers could not be reached (see above)." \
    "Check the network, and the proxy if you need one, then run this command again; what is installed stays."
  [ "${free_mb:-1000}" -ge 500 ] || refuse "the packages could not be installed: only $free_mb MB are free on the disk of / or /var." \
    "Free some space, run apt-get clean && dpkg --configure -a, and then this command again."
  refuse "apt could not install the packages; see its message above. Correct the cause and run this command again." \
    "What is installed stays."
}
