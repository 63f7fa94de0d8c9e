#!/bin/sh
# A run in N parts by GNU parallel, on this machine or on those of --sshloginfile: parallel.sh N FOLDER [ARGUMENTS OF plan...]
# A part that dies is started again, twice at most; what is complete is never done again.
set -eu
n=$1 folder=$2 tool=${PREDICAMENT:-predicament} here=$(cd "$(dirname "$0")" && pwd)
shift 2
mkdir -p "$folder"
[ -f "$folder/plan.json" ] || "$tool" plan "$@" --shards "$n" --out "$folder/plan.json"
seq "$n" | parallel --retries 3 --joblog "$folder/parallel.log" "$here/part.sh" {} "$n" "$folder"
"$tool" merge $(seq -f "$folder/%.0f" "$n") --out "$folder/whole"
