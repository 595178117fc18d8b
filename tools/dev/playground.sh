# SPDX-License-Identifier: MIT
# shellcheck shell=dash
# The page with a simulator in it. Part of ./dev.

playground() {
  [ $# -eq 0 ] || usage
  take_turn
  # shellcheck disable=SC2086
  need $playground_packages
  host_build "the flight simulator" fantail-fly
  build "the module of the page" build/playground 100 playground_commands
  playground_digests >build/playground/native.json
  cmake -D MODULE=build/playground/tools/playground/playground.wasm -D NATIVE=build/playground/native.json \
    -D VERSION="$(sed -n 's/^project(fantail VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)" \
    -D HASH="$(sed -n 's/.*git_hash() { return "\(.*\)"; }/\1/p' build/playground/tools/playground/identity.cpp)" \
    -D OUT=docs/playground.html -P tools/playground/make_page.cmake
  leave_turn
  echo "docs/playground.html: $(($(wc -c <docs/playground.html) / 1024)) kB; open it in a browser, from the disk or a server"
}

playground_commands() {
  configured build/playground playground && cmake --build --preset playground
}

# What the native program records of each shipped scenario, for the page to compare with.
playground_digests() {
  local scenario comma=""
  printf '{"digests": {'
  for scenario in sim/scenarios/*.toml; do
    scenario=$(basename "$scenario" .toml)
    printf '%s"%s": "%s"' "$comma" "$scenario" \
      "$(build/host/fantail fly "$scenario" --json --out "build/playground/native/$scenario" | sed -n 's/.*"log_sha256": "\(.*\)".*/\1/p')"
    comma=", "
  done
  printf '}}\n'
}
