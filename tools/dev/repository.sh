# SPDX-License-Identifier: MIT
# shellcheck shell=dash
# What a stranger looks for in a repository: is it whole and valid? Part of ./dev.

repository_packages="git python3-venv ca-certificates"
actionlint=github.com/rhysd/actionlint/cmd/actionlint@v1.7.7 # the newest that the Go of Debian 12 compiles

# repository: licences, workflow, forms and citation. All are checked, also when one has failed.
repository() {
  [ $# -eq 0 ] || usage
  local version
  take_turn
  # shellcheck disable=SC2086
  need $repository_packages
  # Without git's list, reuse would look into every build.
  git rev-parse --git-dir >/dev/null || refuse "git does not know this folder as a repository (see above), and its list of files is what is checked"
  command -v go >/dev/null || need golang-go
  python_of test/repository build/repository-venv
  actionlint_of build/actionlint || refuse "actionlint could not be installed: Go could not fetch or compile $actionlint (see above)"
  leave_turn
  begin_checks repository
  version=$(sed -n 's/^project(fantail VERSION \([0-9.]*\) .*/\1/p' CMakeLists.txt)
  checked "whose each file is, and its licence" build/repository-venv/bin/reuse --suppress-deprecation lint --lines
  checked "LICENSES/MIT.txt is LICENSE" cmp LICENSE LICENSES/MIT.txt
  checked "the workflows" build/actionlint/bin/actionlint -shellcheck= -pyflakes= .github/workflows/*.yml
  checked "the forms for issues" valid vendor.github-issue-forms .github/ISSUE_TEMPLATE/bug.yml .github/ISSUE_TEMPLATE/question.yml
  checked "what leads to them" valid vendor.github-issue-config .github/ISSUE_TEMPLATE/config.yml
  checked "CITATION.cff" valid vendor.citation-file-format CITATION.cff
  checked "CITATION.cff has version $version, as CMakeLists.txt" grep -qx "version: $version" CITATION.cff
  end_checks "The repository" "./dev repository"
}

# valid SCHEMA FILE...: by a schema that comes with the program, so without the network.
valid() {
  local schema="$1" file said
  shift
  for file in "$@"; do
    [ -f "$file" ] || { echo "repository: there is no $file" >&2 && return 1; }
  done
  said=$(build/repository-venv/bin/check-jsonschema --builtin-schema "$schema" "$@" 2>&1) || {
    echo "$said" >&2
    return 1
  }
}

# Go checks what it fetches against its public list of checksums. What it fetched and compiled is not kept.
actionlint_of() {
  [ "$(cat "$1/version" 2>/dev/null)" != "$actionlint" ] || return 0
  rm -rf "$1"
  mkdir -p "$1" &&
    GOPATH="$root/$1/path" GOCACHE="$root/$1/cache" GOBIN="$root/$1/bin" GOFLAGS=-modcacherw go install "$actionlint" >&2 &&
    rm -rf "$1/path" "$1/cache" && echo "$actionlint" >"$1/version" || {
    rm -rf "$1"
    return 1
  }
}
