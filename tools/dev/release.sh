# SPDX-License-Identifier: MIT
# shellcheck shell=dash
# A release (docs/developing.md). All of it is made in a clone, from the commit on; only what is whole comes into this repository. Part of ./dev.

release_packages="$package_packages git ca-certificates python3-venv python3-dev"

# release VERSION [--dry-run]
release() {
  local version="" dry="" word tree=build/release/tree out new="$root/build/release/new" branch
  for word in "$@"; do
    case "$version,$word" in
      *,--dry-run) dry=-dry-run ;;
      *,-* | ?*,*) usage ;;
      *) version=$word ;;
    esac
  done
  [ -n "$version" ] || usage
  take_turn
  need git python3
  git rev-parse --git-dir >/dev/null || refuse "git does not know this folder as a repository (see above), and a release is a commit of one"
  /usr/bin/python3 -B tools/dev/release.py check "$version" || exit
  [ -z "$(git status --porcelain)" ] ||
    refuse "the sources differ from their commit, and a release is of one: commit, or put aside what git status lists"
  branch=$(git symbolic-ref -q --short HEAD) || branch="no branch"
  [ -n "$dry" ] || [ "$branch" = main ] || refuse "a release is made on main, and this is $branch; --dry-run makes it aside, anywhere"
  git var GIT_COMMITTER_IDENT >/dev/null || refuse "git does not know who commits (see above)"
  # shellcheck disable=SC2086
  need $release_packages
  python_of test/release build/release-venv
  out=$root/build/release/$version$dry
  rm -rf "$tree" "$out" "$new"
  mkdir -p "$new"
  release_in_clone || {
    rm -rf "$new"
    echo "dev: release: $version was not made; see the reasons above. Nothing was committed or tagged here; the attempt is in $tree" >&2
    exit 70
  }
  mv "$new" "$out"
  if [ -z "$dry" ]; then
    git fetch -q --no-tags "$tree" "refs/tags/v$version:refs/tags/v$version" && git merge -q --ff-only "v$version" || {
      ! git tag -d "v$version" >/dev/null 2>&1 || echo "dev: release: the tag v$version was removed again" >&2
      refuse "the commit of the release could not be put on main (see above); the files of $out are of no commit here"
    }
    echo "release: main and the tag v$version are this release, and nothing was pushed: git push origin main v$version"
  fi
  rm -rf "$tree"
  echo "release: build/release/$version$dry:"
  (cd "$out" && du -k -- * | awk '{ printf "  %s  %d kB\n", $2, $1 }')
}

# In the clone: the commit and its tag, and every file of it, in $new.
release_in_clone() (
  name=$(git config user.name) && email=$(git config user.email) || name="" # else from the environment, as git var has found
  git clone -q . "$tree" && cd "$tree" || exit
  [ -z "$name" ] || { git config user.name "$name" && git config user.email "$email" || exit; }
  date=$(date -u +%F)
  /usr/bin/python3 -B tools/dev/release.py write "$version" "$date" &&
    git commit -q -a -m "Fantail $version" &&
    git tag -a -m "Fantail $version" "v$version" || exit
  commit=$(git rev-parse HEAD)
  SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
  export SOURCE_DATE_EPOCH
  exec 9>&- # the turn is that of the folder above
  ./dev package && ./dev wheel || exit
  deb=build/packages/fantail_${version}_amd64.deb
  sources=build/packages/fantail-$version.tar.gz
  wheel=$(echo build/wheels/fantail-"$version"-*.whl)
  image=build/arm/fantail-stm32f405
  cp "$deb" "$sources" "$wheel" "$image.elf" "$image.hex" "$image.bin" "$image.map" "$new" &&
    /usr/bin/python3 -B tools/dev/sbom.py "$new/sbom.spdx.json" "$version" "$commit" "$SOURCE_DATE_EPOCH" \
      "$deb" "$wheel" "$image.elf" "$sources" &&
    "$root/build/release-venv/bin/pyspdxtools" -i "$new/sbom.spdx.json" &&
    /usr/bin/python3 -B tools/dev/release.py page "$version" "$date" "$commit" "$new" &&
    (cd "$new" && sha256sum -- * >../SHA256SUMS && mv ../SHA256SUMS .)
)
