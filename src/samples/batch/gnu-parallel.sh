#!/usr/bin/env bash
# A batch in parts, by GNU parallel, on this machine or on others:
#   gnu-parallel.sh SHARDS IN OUT [OPTION of lodsmith generate]...
# GNU parallel takes further options from the variable PARALLEL. Machines that see IN and OUT under the same paths:
#   PARALLEL="--sshlogin 8/build1,8/build2 --workdir ." gnu-parallel.sh 64 models out
# A part that is lost is run again, here or elsewhere, and does what is left.
set -euo pipefail
shards=$1 in=$2 out=$3
shift 3
seq "$shards" \
    | parallel --quote --retries 3 lodsmith generate "$in" -o "$out" --shard "{}/$shards" --jobs 1 "$@" >/dev/null || true
# Everything once more: finds it up to date, makes what is missing all the same, and tells what cannot be made.
exec lodsmith generate "$in" -o "$out" "$@"
