#!/bin/sh
# One part of a plan, to be started by any engine, and again if it died: part.sh K N FOLDER, with FOLDER/plan.json
# A part that is complete is left alone, one that was begun is gone on with. Findings are no failure: `merge` and `gate` judge the whole.
set -u
k=$1 n=$2 plan=$3/plan.json part=$3/$1 tool=${PREDICAMENT:-predicament}
if grep -qs '"outcome": "complete"' "$part/state.json"; then exit 0; fi
if [ -f "$part/state.json" ]; then
    "$tool" run --quiet --resume "$part"
else
    rm -rf "$part" # Killed before its first byte counted: nothing is lost.
    "$tool" run --quiet --plan "$plan" --shard "$k/$n" --out "$part"
fi
code=$?
case $code in 0 | 100 | 101) exit 0 ;; *) exit $code ;; esac
