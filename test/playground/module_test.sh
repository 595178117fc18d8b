#!/bin/sh
# SPDX-License-Identifier: MIT
# Usage: module_test.sh BUILD FANTAIL
# Exit code 77: the module was never built here, or there is no node.
set -eu
here=$(dirname -- "$(readlink -f -- "$0")")
[ -s "$1/build.ninja" ] || { echo "SKIPPED: $1 is not configured; ./dev playground does it" && exit 77; }
command -v node >/dev/null || { echo "SKIPPED: node is not installed" && exit 77; }
cmake --build "$1"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
node --test-reporter=spec "$here/settings_test.js"
node "$here/module_test.js" "$1/tools/playground/playground.wasm" "$2" "$work"
