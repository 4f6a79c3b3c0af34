#!/bin/bash
# Thumbnails of many structures by GNU parallel: parallel.sh FOLDER_OUT STRUCTURE...
# Run it again after an interruption: finished pictures are skipped.
set -euo pipefail
out=$1
shift
mkdir -p "$out"

# One JSON object per picture, named by the whole file name (1crn.pdb.png, 1crn.cif.png). Names with quotes or backslashes
# need a tool that writes JSON.
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
    # Each process draws 500 pictures with a device of its own. For more machines, add --sshlogin and a shared folder.
    parallel --will-cite --pipe --max-args 500 --jobs "${JOBS:-2}" --joblog "$out/parallel.log" \
        nacre batch - --resume --quiet --jobs 1 --size 256x256 --occlusion-detail 12 >"$out/report.jsonl"
