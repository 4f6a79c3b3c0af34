#!/bin/bash
# Thumbnails of many structures by GNU parallel: parallel.sh FOLDER_OUT STRUCTURE...
# Run it again after whatever stopped it: what is there is left out.
set -euo pipefail
out=$1
shift
mkdir -p "$out"

# One JSON object a picture, by the structure's whole name (1crn.pdb.png, 1crn.cif.png); names with quotes or backslashes
# in them want a tool that knows JSON.
declare -A drawn
for structure in "$@"; do
    name=$(basename "$structure")
    if [[ -n ${drawn[$name]-} ]]; then
        echo "parallel.sh: $structure and ${drawn[$name]} would have one picture" >&2
        exit 2
    fi
    drawn[$name]=$structure
done

for name in "${!drawn[@]}"; do
    printf '{"input": "%s", "output": "%s/%s.png"}\n' "${drawn[$name]}" "$out" "$name"
done |
    # Each process draws 500 pictures with a device of its own; more machines: --sshlogin, and a shared folder.
    parallel --will-cite --pipe --max-args 500 --jobs "${JOBS:-2}" --joblog "$out/parallel.log" \
        nacre batch - --resume --quiet --jobs 1 --size 256x256 --occlusion-detail 12 >"$out/report.jsonl"
