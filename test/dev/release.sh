#!/bin/sh
# SPDX-License-Identifier: MIT
# Usage: release.sh PROJECT
# ./dev release in a small repository made for it, in which packages, wheel and bill of materials are stand-ins: what it refuses,
# what it writes, and that nothing is left where a step fails. Also that CITATION.cff has the version of the project.
# Ends with 77 (skipped) without git.
set -eu
project=$1
command -v git >/dev/null || { echo "SKIPPED: git is not installed" && exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
  echo "FAILED: $*"
  [ ! -s "$work/said" ] || tail -n 20 "$work/said"
  exit 1
}

# The project itself. What else has its version takes it from CMakeLists.txt.
version=$(sed -n 's/^project(fantail VERSION \([0-9.]*\) .*/\1/p' "$project/CMakeLists.txt")
grep -qx "version: $version" "$project/CITATION.cff" || fail "CITATION.cff has not the version $version of CMakeLists.txt"

export GIT_CONFIG_GLOBAL="$work/config" GIT_CONFIG_NOSYSTEM=1
git config --global user.name Somebody
git config --global user.email somebody@example.org
git config --global init.defaultBranch main
here=$work/project
mkdir -p "$here/tools" "$here/docs/figures" "$here/test/release"
cd "$here"
git init -q
cp "$project/dev" .
cp -r "$project/tools/dev" tools/
printf 'build/\n' >.gitignore
printf 'project(fantail VERSION 0.1.0 LANGUAGES C CXX)\n' >CMakeLists.txt
printf 'cff-version: 1.2.0\nversion: 0.1.0\nlicense: MIT\n' >CITATION.cff
printf '# Changelog\n\n## Unreleased\n\n## 0.1.0 (2020-01-01)\n\n- Old [page](docs/old.md).\n' >CHANGELOG.md
printf '# Gates\n\nSee [proofs](../proofs.md#all) and [the rule](https://example.org).\n' >docs/figures/gates.md
: >test/release/requirements.txt
cat >>tools/dev/release.sh <<'END'
need() { :; }
python_of() {
  mkdir -p "$2/bin"
  printf '#!/bin/sh\ntest -s "$2"\n' >"$2/bin/pyspdxtools"
  chmod +x "$2/bin/pyspdxtools"
}
package() {
  [ ! -e "$root/../../moves" ] || git -C "$root/../../.." commit -q --allow-empty -m Meanwhile
  version=$(project_version)
  mkdir -p build/packages build/arm
  for file in "packages/fantail_${version}_amd64.deb" "packages/fantail-$version.tar.gz" arm/fantail-stm32f405.elf arm/fantail-stm32f405.hex \
    arm/fantail-stm32f405.bin arm/fantail-stm32f405.map; do
    echo "$file at $SOURCE_DATE_EPOCH" >"build/$file"
  done
}
wheel() {
  [ ! -e "$root/../../no_wheel" ] || exit 70
  mkdir -p build/wheels && echo wheel >"build/wheels/fantail-$(project_version)-cp311-cp311-linux_x86_64.whl"
}
END
printf 'import sys\nopen(sys.argv[1], "w").write(" ".join(sys.argv[2:]))\n' >tools/dev/sbom.py
git add -A
git commit -q -m Begin

# expect CODE TEXT ARGUMENT...: the exit code, what is said, and that commit, tags and tree are as they were.
expect() {
  code=0 wanted=$1 text=$2
  shift 2
  before=$(git rev-parse HEAD && git tag && git status --porcelain)
  ./dev release "$@" >"$work/said" 2>&1 </dev/null || code=$?
  [ "$code" = "$wanted" ] || fail "./dev release $*: exit code $code instead of $wanted:"
  grep -qF -- "$text" "$work/said" || fail "./dev release $*: nothing of \"$text\" in:"
  [ "$(git rev-parse HEAD && git tag && git status --porcelain)" = "$before" ] || fail "./dev release $* has changed the repository"
}
unreleased() { # TEXT
  sed -i "s/^## Unreleased\$/&\\n\\n- $1/" CHANGELOG.md
  git commit -q -a -m "$1"
}

expect 64 "usage:"
expect 64 "usage:" 0.2.0 0.3.0
expect 64 "usage:" 0.2.0 --push
for none in 0.2 v0.2.0 0.2.0-rc1 0.02.0 0.2.0.0; do
  expect 64 "\"$none\" is not a version" "$none"
done
expect 64 "0.1.0 is not greater than 0.1.0, the last version" 0.1.0
expect 64 "0.0.9 is not greater than 0.1.0" 0.0.9
expect 69 '"## Unreleased" in CHANGELOG.md is empty' 0.2.0
unreleased "New [page](docs\\/new.md)."
: >untracked
expect 69 "the sources differ from their commit" 0.2.0 --dry-run
rm untracked
git checkout -q -b other
expect 69 "a release is made on main, and this is other" 0.2.0
expect 0 "build/release/0.2.0-dry-run:" 0.2.0 --dry-run
git checkout -q main

# A step that fails leaves nothing.
: >build/no_wheel
expect 70 "0.2.0 was not made" 0.2.0
[ ! -e build/release/0.2.0 ] && [ ! -e build/release/new ] || fail "files of a release that was not made were left behind"
rm build/no_wheel

# Nor does one behind whose back somebody has committed.
: >build/moves
code=0
./dev release 0.2.0 >"$work/said" 2>&1 || code=$?
[ "$code" = 69 ] && grep -q "could not be put on main" "$work/said" || fail "exit code $code of a release whose main has moved:"
[ -z "$(git tag)" ] && [ "$(git log -1 --format=%s)" = Meanwhile ] || fail "a release whose main has moved was put there"
rm build/moves

# Whole.
./dev release 0.2.0 >"$work/said" 2>&1 || fail "no release was made:"
[ "$(git log -1 --format=%s)" = "Fantail 0.2.0" ] && [ -z "$(git status --porcelain)" ] || fail "the commit of the release is not on main"
[ "$(git rev-parse 'v0.2.0^{commit}')" = "$(git rev-parse HEAD)" ] && [ "$(git cat-file -t v0.2.0)" = tag ] || fail "there is no tag with a message"
[ "$(git log -1 --format=%an)" = Somebody ] || fail "somebody else has committed"
grep -q "^project(fantail VERSION 0.2.0 " CMakeLists.txt || fail "CMakeLists.txt has not the version"
today=$(git show -s --format=%cs HEAD)
printf 'cff-version: 1.2.0\nversion: 0.2.0\ndate-released: %s\nlicense: MIT\n' "$today" | cmp - CITATION.cff || fail "CITATION.cff is not that of the release"
printf '# Changelog\n\n## Unreleased\n\n## 0.2.0 (%s)\n\n- New [page](docs/new.md).\n\n## 0.1.0 (2020-01-01)\n\n- Old [page](docs/old.md).\n' "$today" |
  cmp - CHANGELOG.md || fail "the section of the changelog was not moved"
cd build/release/0.2.0
[ "$(echo *)" = "SHA256SUMS fantail-0.2.0-cp311-cp311-linux_x86_64.whl fantail-0.2.0.tar.gz fantail-stm32f405.bin fantail-stm32f405.elf \
fantail-stm32f405.hex fantail-stm32f405.map fantail_0.2.0_amd64.deb release.md sbom.spdx.json" ] || fail "these are not the files of a release: $(echo *)"
sha256sum --quiet -c SHA256SUMS && [ "$(wc -l <SHA256SUMS)" -eq 9 ] || fail "SHA256SUMS does not fit the files"
grep -q " at $(git show -s --format=%ct HEAD)\$" fantail_0.2.0_amd64.deb || fail "the package was not made with the time of the commit"
grep -qF "0.2.0 $(git rev-parse HEAD)" sbom.spdx.json || fail "the bill of materials is of another commit"
grep -qF "$(sha256sum <fantail-stm32f405.bin | cut -d' ' -f1)" release.md || fail "the page has not the sum of the image"
grep -qF "[page](docs/new.md)" release.md && ! grep -q Old release.md || fail "the page has not the changes of this release alone"
grep -qxF "## Gates" release.md && grep -qF "[proofs](docs/proofs.md#all) and [the rule](https://example.org)" release.md ||
  fail "the page has not the figures of the commit"

# And the next one.
cd "$here"
expect 69 '"## Unreleased" in CHANGELOG.md is empty' 0.3.0
unreleased Newer.
expect 69 "the tag v0.2.0 exists already" 0.2.0
git tag v0.9.0
git tag v0.10.0
expect 64 "0.9.1 is not greater than 0.10.0, the last version" 0.9.1
git tag v1.0.0
expect 64 "0.3.0 is not greater than 1.0.0, the last version" 0.3.0
expect 0 "build/release/1.0.1-dry-run:" 1.0.1 --dry-run
sed -i 's/^version: .*//' CITATION.cff
git commit -q -a -m "No version"
expect 70 "CITATION.cff has 0 places for the text of the release" 1.0.1
