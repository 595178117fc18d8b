#!/bin/sh
# SPDX-License-Identifier: MIT
# Usage: on_loopback.sh [--no-guest] COMMAND [ARGUMENT...]
# Runs a command where there is no network but loopback, up, and no route for multicast; as one who may add one. In a
# network namespace where this machine lets us make one, else in a user-mode Linux guest. 77: neither is possible.
set -u
guest=yes
[ "$1" != --no-guest ] || { guest="" && shift; }
for way in "unshare --net" "unshare --net --map-root-user"; do
  # shellcheck disable=SC2086 # words of a command
  if $way ip link set lo up 2>/dev/null; then
    # shellcheck disable=SC2016 # the inner shell expands
    exec $way sh -c 'ip link set lo up && exec "$@"' sh "$@"
  fi
done
if [ -z "$guest" ]; then
  echo "on_loopback: SKIPPED, the command did not run: no network namespace can be made here" >&2
  exit 77
fi
exec "$(dirname -- "$0")/../../tools/with_vcan" --guest --timeout 240 "$@"
