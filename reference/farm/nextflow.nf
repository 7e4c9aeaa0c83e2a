// A step for Nextflow: a list of jobs in parts. nextflow run nextflow.nf --jobs jobs.tsv --shards 20
// The names in the list are absolute: each task runs in a folder of its own.
params.jobs = 'jobs.tsv'
params.shards = 20
params.log = 'log'

process drawShard {
    cpus 2
    memory '1 GB'
    errorStrategy 'retry'
    maxRetries 3

    input:
    path jobs
    val number

    output:
    val number

    script:
    """
    softgl batch ${jobs} --shard ${number}/${params.shards} --resume \
      --report '${file(params.log)}/{shard}.jsonl' --threads ${task.cpus}
    """
}

workflow {
    drawShard(file(params.jobs), Channel.of(1..params.shards))
}
