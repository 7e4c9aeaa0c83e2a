#!/bin/sh
# A list of jobs in parts, one for each task of a Slurm array: sbatch --array=1-100 slurm.sh
# What is set from outside: JOBS (the list), OPTIONS (for all jobs), LOG (a folder), SOFTGL (the program).
#SBATCH --job-name=softgl
#SBATCH --ntasks=1
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --signal=TERM@30
set -eu
# Slurm starts this file from a folder of its own: names are those from where sbatch was called.
cd "${SLURM_SUBMIT_DIR:-.}"
# OPTIONS is cut into words. exec: the signal is for softgl, and its exit code is the task's.
# shellcheck disable=SC2086
exec "${SOFTGL:-softgl}" batch "${JOBS:-jobs.tsv}" ${OPTIONS:-} \
  --shard slurm --resume --report "${LOG:-log}/{shard}.jsonl" --threads "${SLURM_CPUS_PER_TASK:-1}"
