#!/bin/sh
# A run in N parts by GNU parallel, on this machine or on those of --sshloginfile: parallel.sh N FOLDER [ARGUMENTS OF run...]
# A part that dies is started again, twice at most; what is complete is never done again.
set -eu
n=$1 folder=$2
shift 2
mkdir -p "$folder"
seq "$n" | parallel --retries 3 --joblog "$folder/parallel.log" "$(dirname "$0")/part.sh" {} "$n" "$folder" "$@"
"${PREDICAMENT:-predicament}" merge $(seq -f "$folder/%.0f" "$n") --out "$folder/whole"
