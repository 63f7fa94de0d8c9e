#!/bin/sh
# A run in N parts as a Slurm job array, and their merge after all of them: slurm.sh N FOLDER [ARGUMENTS OF run...]
# The folder has to be on a file system that all nodes share. A node that fails gives its part back to the queue (--requeue).
set -eu
n=$1 folder=$2
shift 2
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$folder"
job=$(sbatch --parsable --requeue --array="1-$n" --output="$folder/%a.log" \
    --wrap "exec '$here/part.sh' \"\$SLURM_ARRAY_TASK_ID\" $n '$folder' $*")
sbatch --dependency="afterok:$job" --output="$folder/merge.log" \
    --wrap "${PREDICAMENT:-predicament} merge $(seq -s ' ' -f "$folder/%.0f" "$n") --out $folder/whole"
