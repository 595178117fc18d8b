#!/bin/sh
# SPDX-License-Identifier: MIT
# Flies a campaign on a Slurm cluster:
#   slurm.sh SHARDS FOLDER WORDS...   e.g. slurm.sh 100 /scratch/me/launch tasha3_launch2 --runs 1000000 --at-least 95
# WORDS are those of fantail campaign, without --shard, --threads and --out. FOLDER is on a file system that all nodes see.
# Three jobs: an array with one task for each shard; the same array once more, in which a shard that is finished is done at
# once and one that failed goes on from what it has stored; and one that merges them and writes the page into FOLDER/whole.
# Partition, account, time limit: as for every sbatch, by SBATCH_PARTITION, SBATCH_ACCOUNT, SBATCH_TIMELIMIT.
# FANTAIL names the program where it is not in PATH. Exit code: 64 for wrong words, else that of sbatch.
set -eu

usage() {
  sed -n 's/^#   //p' "$0" >&2
  exit 64
}

[ $# -ge 3 ] || usage
shards=$1 folder=$2
shift 2
case $shards in "" | *[!0-9]* | 0) usage ;; esac
for word in "$@"; do
  case $word in --shard | --shard=* | --threads | --threads=* | --out | --out=* | --json | merge)
    echo "slurm.sh: $word is not for a campaign on a cluster" >&2
    exit 64
    ;;
  esac
done
mkdir -p "$folder/logs"
folder=$(cd "$folder" && pwd)

# A word as a shell takes it for one.
quoted() {
  printf "'%s'" "$(printf '%s' "$1" | sed "s/'/'\\\\''/g")"
}

words=""
for word in "$@"; do words="$words$(quoted "$word") "; done
fantail=$(quoted "${FANTAIL:-fantail}")
shard="exec $fantail campaign $words--threads 1 --shard \$SLURM_ARRAY_TASK_ID/$shards \
--out $(quoted "$folder")/shard_\$SLURM_ARRAY_TASK_ID"
merge="set --; for number in \$(seq $shards); do set -- \"\$@\" $(quoted "$folder")/shard_\$number; done
$fantail campaign merge \"\$@\" --out $(quoted "$folder")/whole &&
exec $fantail campaign $words--out $(quoted "$folder")/whole"

# submit NAME COMMAND OPTION...: the number of the new job.
submit() {
  name=$1 command=$2
  shift 2
  sbatch --parsable --job-name "fantail-$name" --requeue --open-mode append --output "$folder/logs/$name-%A_%a.log" "$@" \
    --wrap "$command" | cut -d ';' -f 1
}

first=$(submit shards "$shard" --array "1-$shards")
again=$(submit again "$shard" --array "1-$shards" --dependency "afterany:$first" --kill-on-invalid-dep yes)
whole=$(submit merge "$merge" --dependency "afterok:$again" --kill-on-invalid-dep yes)
echo "jobs $first (shards), $again (those that failed, again), $whole (merge); the result will be in $folder/whole," \
  "what the jobs say in $folder/logs"
