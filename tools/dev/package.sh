# SPDX-License-Identifier: MIT
# shellcheck shell=dash
# What others install: a Debian package, and the sources as one file. Part of ./dev, which has set $root.

package() {
  local epoch version
  case "$*" in
    "" | --lint | --check | --container) ;;
    *) usage ;;
  esac
  if [ "$*" = --container ]; then
    [ "$(id -u)" -eq 0 ] || refuse "the steps are run in bare Debian systems, which only root may enter: sudo ./dev package --container"
    need python3 debootstrap
    exec /usr/bin/python3 -B test/package/container.py build/bare Dockerfile .devcontainer/Dockerfile
  fi
  take_turn
  # shellcheck disable=SC2086
  need $package_packages
  git rev-parse --git-dir >/dev/null || refuse "a package is of a commit, and git knows none here (see above)"
  [ -z "$(git status --porcelain)" ] ||
    refuse "the sources differ from their commit, and a package is of one: commit, or put aside what git status lists"
  version=$(project_version)
  epoch=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct)}
  arm_build "the flight image" fantail-stm32f405
  host_build "every verb" verbs manual
  debian_documents "$version" "$epoch"
  rm -rf build/packages
  # CPack says a line for each step; they are of interest when one fails.
  SOURCE_DATE_EPOCH=$epoch TZ=UTC0 cpack --config build/host/CPackConfig.cmake -G DEB -B build/packages >build/host/package.log 2>&1 || {
    cat build/host/package.log >&2
    echo "dev: the package could not be made; see the reasons above" >&2
    exit 70
  }
  rm -rf build/packages/_CPack_Packages
  git archive --format=tar --prefix="fantail-$version/" HEAD | gzip -9n >"build/packages/fantail-$version.tar.gz"
  (cd build/packages && sha256sum -- *.deb *.tar.gz >SHA256SUMS)
  leave_turn
  (cd build/packages && du -k -- *.deb *.tar.gz | awk '{ printf "build/packages/%s  %d kB\n", $2, $1 }')
  [ -z "$*" ] || lint_package "build/packages/fantail_${version}_amd64.deb"
  [ "$*" != --check ] || check_package "build/packages/fantail_${version}_amd64.deb" "build/packages/fantail-$version.tar.gz"
}

# lint_package DEB: by what Debian asks of a package; what it overrides says why (cmake/package/lintian-overrides).
lint_package() {
  need lintian
  begin_checks package
  checked "lintian has no error and no warning" lintian --fail-on error,warning "$1"
  end_checks "The package" "./dev package --lint"
}

# check_package DEB SOURCES: in bare systems, and installed where names are unusual.
check_package() {
  local prefix="$root/build/a prefix für Ölbaum"
  rm -rf "$prefix"
  (install --prefix "$prefix")
  (cd build && "$prefix/bin/fantail" fly --out "$prefix/out" >/dev/null && [ -s "$prefix/out/report.html" ])
  rm -rf "$prefix"
  echo "package: installed into a folder with spaces and other letters, it flies: passed"
  /usr/bin/python3 -B test/package/check.py "$1" "$2" build/bare
}

project_version() {
  sed -n 's/^project(fantail VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt
}

# debian_documents VERSION SECONDS: what a package has in /usr/share/doc.
debian_documents() {
  local folder=build/host/debian library
  mkdir -p "$folder"
  {
    cat cmake/package/copyright LICENSE
    printf '\nuPlot\n-----\n'
    cat third_party/uplot/LICENSE
    for library in libfmt9 libcpp-httplib0.11 libzip4; do
      printf '\n%s\n-----\n' "$library"
      cat "/usr/share/doc/$library/copyright"
    done
  } >"$folder/copyright"
  printf 'fantail (%s) stable; urgency=medium\n\n  * What has changed is in /usr/share/doc/fantail/CHANGELOG.md.gz.\n\n -- The Fantail authors <fantail@localhost>  %s\n' \
    "$1" "$(LC_ALL=C date -u -R -d "@$2")" | gzip -9n >"$folder/changelog.gz"
  gzip -9n <CHANGELOG.md >"$folder/CHANGELOG.md.gz"
}
