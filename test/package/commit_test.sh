#!/bin/sh
# SPDX-License-Identifier: MIT
# Usage: commit_test.sh SOURCE
# What the sources are said to be, and of which day, in a repository, in an archive of it, and in neither.
set -eu
source=$1
command -v git >/dev/null || { echo "git is not installed" && exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset SOURCE_DATE_EPOCH

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

# expect HASH DAY FOLDER
expect() {
  cmake -D SOURCE="$3" -D VERSION=1.2.3 -D OUT="$work/identity.cpp" -P "$source/cmake/identity.cmake"
  cmake -D SOURCE="$3" -D OUT="$work/day" -P "$source/cmake/day_of_sources.cmake"
  grep -qF "git_hash() { return \"$1\"; }" "$work/identity.cpp" || fail "$3 is not $1: $(grep git_hash "$work/identity.cpp")"
  [ "$(cat "$work/day")" = "$2" ] || fail "$3 is not of $2 but of $(cat "$work/day")"
}

repository=$work/repository
mkdir -p "$repository/cmake"
cp "$source/.gitattributes" "$repository/"
cp "$source/cmake/commit.txt" "$repository/cmake/"
touch -d 2001-02-03 "$repository/CHANGELOG.md"
expect unknown 2001-02-03 "$repository"

export GIT_CONFIG_GLOBAL=/dev/null GIT_AUTHOR_NAME=a GIT_AUTHOR_EMAIL=a@localhost GIT_COMMITTER_NAME=a GIT_COMMITTER_EMAIL=a@localhost
export GIT_COMMITTER_DATE=2010-11-12T13:14:15Z
git -C "$repository" init -q
git -C "$repository" add .
git -C "$repository" commit -q -m one
digits=$(git -C "$repository" rev-parse HEAD | cut -c 1-12)
expect "$digits" 2010-11-12 "$repository"
mkdir "$work/archive"
git -C "$repository" archive HEAD | tar -C "$work/archive" -x
expect "$digits-archive" 2010-11-12 "$work/archive"
echo changed >>"$repository/cmake/commit.txt"
expect "$digits-dirty" 2010-11-12 "$repository"
export SOURCE_DATE_EPOCH=86400
expect "$digits-archive" 1970-01-02 "$work/archive"
