#!/bin/sh
# SPDX-License-Identifier: MIT
# A campaign on a real Slurm of one node, which this test starts and stops: a shard is killed in the middle, and the result
# has the bytes of the campaign flown as one. slurm_test.sh FANTAIL SLURM_SH
set -eu
fantail=$1 script=$2
PATH=$PATH:/usr/sbin
for program in munged slurmctld slurmd sbatch; do
  command -v "$program" >/dev/null || { echo "SKIPPED: no $program; ./dev test --all installs it" && exit 77; }
done

base=$(mktemp -d)
pids=""
stop() {
  for pid in $pids; do kill "$pid" 2>/dev/null || true; done
  wait
  rm -rf "$base"
}
trap stop EXIT
fail() {
  echo "FAILED: $*"
  tail -n 20 "$base"/*.log "$base"/out/logs/* 2>/dev/null || true
  exit 1
}
# eventually WORDS: until the command succeeds, for two minutes.
eventually() {
  tries=0
  until "$@" >/dev/null 2>&1; do
    tries=$((tries + 1))
    [ $tries -lt 1200 ] || fail "in vain: $*"
    sleep 0.1
  done
}

host=$(hostname -s)
mkdir -p "$base/run" "$base/state" "$base/spool"
chmod 755 "$base" "$base/run"
head -c 1024 /dev/urandom >"$base/munge.key"
chmod 400 "$base/munge.key"
cat >"$base/slurm.conf" <<EOF
ClusterName=fantail
SlurmctldHost=$host(127.0.0.1)
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$base/run/munge.sock
CryptoType=crypto/munge
SlurmctldPort=26817
SlurmdPort=26818
StateSaveLocation=$base/state
SlurmdSpoolDir=$base/spool
SlurmctldPidFile=$base/run/slurmctld.pid
SlurmdPidFile=$base/run/slurmd.pid
SlurmctldLogFile=$base/slurmctld.log
SlurmdLogFile=$base/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerType=sched/backfill
SchedulerParameters=sched_min_interval=0,batch_sched_delay=0
MpiDefault=none
ReturnToService=2
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MinJobAge=60
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 RealMemory=500 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
EOF
# Where control groups are not mounted, a newer slurmd does not start without this, and an older one with it.
case $(slurmd -V) in *" 2"[0-2].*) ;; *) echo CgroupPlugin=disabled >"$base/cgroup.conf" ;; esac
export SLURM_CONF="$base/slurm.conf"
munged --foreground --force --key-file="$base/munge.key" --socket="$base/run/munge.sock" --pid-file="$base/run/munged.pid" \
  --log-file="$base/munged.log" --seed-file="$base/munge.seed" >/dev/null 2>&1 &
pids=$!
eventually test -S "$base/run/munge.sock"
slurmctld -D -f "$SLURM_CONF" >/dev/null 2>&1 &
pids="$! $pids"
slurmd -D -f "$SLURM_CONF" -N "$host" >/dev/null 2>&1 &
pids="$! $pids"
eventually sh -c 'sinfo -h -o %T | grep -q idle'

runs=320
FANTAIL=$fantail "$script" 3 "$base/out" tasha3_launch2 --runs $runs --set 'body.name="It'\''s ours"' >"$base/said" ||
  fail "not submitted"
grep -q '^jobs [0-9]* (shards), [0-9]* (those that failed, again), [0-9]* (merge)' "$base/said" || fail "$(cat "$base/said")"
eventually test -e "$base/out/shard_2/parts/00000064.part"
killed=""
for process in /proc/[0-9]*; do
  ! tr '\0' ' ' 2>/dev/null <"$process/cmdline" | grep -q -- '--shard 2/3 --out ' || {
    kill -KILL "${process#/proc/}" && killed=yes
  }
done
[ -n "$killed" ] || fail "no shard to kill"
eventually test -e "$base/out/whole/campaign.html"
[ -e "$base/out/whole/runs.csv.gz" ] || fail "nothing was merged"

"$fantail" campaign tasha3_launch2 --runs $runs --set 'body.name="It'\''s ours"' --out "$base/alone" >/dev/null
for file in runs.csv.gz campaign.json summary.json; do
  cmp "$base/alone/$file" "$base/out/whole/$file" || fail "$file is not that of the campaign flown as one"
done

for words in "0 $base/x tasha3_launch2" "2 $base/x tasha3_launch2 --out y" "2 $base/x"; do
  code=0
  # shellcheck disable=SC2086
  "$script" $words >/dev/null 2>&1 || code=$?
  [ $code = 64 ] || fail "slurm.sh $words: exit code $code instead of 64"
done
echo "3 shards, one of them killed and flown again: the bytes of the campaign flown as one"
