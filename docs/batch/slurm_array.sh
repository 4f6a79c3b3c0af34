#!/bin/bash
#SBATCH --array=0-9
#SBATCH --cpus-per-task=2
#SBATCH --output=nacre-%A-%a.log
# Pictures by a Slurm array: sbatch slurm_array.sh jobs.jsonl. Each task takes every tenth line. `sbatch` again
# afterwards draws what is missing.
set -euo pipefail
jobs=$1
tasks=$SLURM_ARRAY_TASK_COUNT
task=$((SLURM_ARRAY_TASK_ID - SLURM_ARRAY_TASK_MIN))
if ((SLURM_ARRAY_TASK_MAX - SLURM_ARRAY_TASK_MIN + 1 != tasks)); then
    echo "slurm_array.sh: the array skips numbers, and would skip jobs" >&2
    exit 2
fi

awk -v tasks="$tasks" -v task="$task" 'NR % tasks == task' "$jobs" |
    nacre batch - --resume --jobs "${SLURM_CPUS_PER_TASK:-1}" >"${jobs%.jsonl}.$SLURM_ARRAY_TASK_ID.report.jsonl"
