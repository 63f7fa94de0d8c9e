#!/bin/sh
# A run in N parts as a Slurm job array, and their merge after all of them: slurm.sh N FOLDER [ARGUMENTS OF plan...]
# The folder has to be on a file system that all nodes share. Slurm gives the part of a node that fails to another (--requeue); one that dies
# by itself asks to be put back into the queue, twice at most.
set -eu
n=$1 folder=$2 tool=${PREDICAMENT:-predicament} here=$(cd "$(dirname "$0")" && pwd)
shift 2
mkdir -p "$folder"
[ -f "$folder/plan.json" ] || "$tool" plan "$@" --shards "$n" --out "$folder/plan.json"
job=$(sbatch --parsable --requeue --array="1-$n" --open-mode=append --output="$folder/%a.log" --wrap "'$here/part.sh' \$SLURM_ARRAY_TASK_ID $n '$folder' && exit
    code=\$?; [ \${SLURM_RESTART_COUNT:-0} -lt 2 ] && scontrol requeue \${SLURM_ARRAY_JOB_ID}_\$SLURM_ARRAY_TASK_ID; exit \$code")
sbatch --dependency="afterok:$job" --kill-on-invalid-dep=yes --output="$folder/merge.log" \
    --wrap "'$tool' merge $(seq -s ' ' -f "'$folder/%.0f'" "$n") --out '$folder/whole'"
