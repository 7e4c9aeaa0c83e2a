#!/bin/sh
# A list of jobs in parts, by GNU parallel: on this machine, or on those of a file: sh parallel.sh 8 --sshloginfile nodes
# What is set from outside: JOBS (the list), OPTIONS (for all jobs), LOG (a folder), SOFTGL (the program).
set -eu
shards=${1:-$(nproc)}
[ $# -eq 0 ] || shift
# Each part has one thread: parallel starts as many parts at once as a machine has processors. A part that fails, or whose
# machine does, is tried again and draws what is missing.
seq "$shards" | parallel --will-cite --retries 3 --workdir . "$@" \
  "${SOFTGL:-softgl} batch '${JOBS:-jobs.tsv}' ${OPTIONS:-} --shard {}/$shards --resume \
   --report '${LOG:-log}/{shard}.jsonl' --threads 1"
