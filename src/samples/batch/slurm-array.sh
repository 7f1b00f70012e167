#!/usr/bin/env bash
#SBATCH --job-name=lodsmith
#SBATCH --requeue
#SBATCH --output=lodsmith-%A-%a.log
#SBATCH --open-mode=append
# One part of a batch, as a task of a Slurm job array:
#   sbatch --array=1-SHARDS slurm-array.sh SHARDS IN OUT [OPTION of lodsmith generate]...
# IN and OUT are directories that all nodes see. A task that is lost, killed or requeued is run again and does what is left.
set -euo pipefail
shards=$1 in=$2 out=$3
shift 3
# The number of parts is told and not taken from Slurm, so that a single task can be submitted again: --array=3.
exec lodsmith generate "$in" -o "$out" --shard "$SLURM_ARRAY_TASK_ID/$shards" --jobs "${SLURM_CPUS_ON_NODE:-1}" "$@"
