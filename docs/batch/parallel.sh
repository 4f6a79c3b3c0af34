#!/bin/bash
# Thumbnails of many structures by GNU parallel: parallel.sh FOLDER_OUT STRUCTURE...
# Run it again after whatever stopped it: what is there is left out.
set -euo pipefail
out=$1
shift
mkdir -p "$out"

# One JSON object a picture; names with quotes or backslashes in them want a tool that knows JSON.
for structure in "$@"; do
    name=$(basename "$structure")
    printf '{"input": "%s", "output": "%s/%s.png"}\n' "$structure" "$out" "${name%%.*}"
done |
    # Each process draws 500 pictures with a device of its own; more machines: --sshlogin, and a shared folder.
    parallel --will-cite --pipe --max-args 500 --jobs "${JOBS:-2}" --joblog "$out/parallel.log" \
        nacre batch - --resume --quiet --jobs 1 --size 256x256 --occlusion-detail 12 >"$out/report.jsonl"
