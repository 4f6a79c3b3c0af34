#!/bin/bash
# Installs a build, builds the example against what was installed and nothing else, and runs it.
# run.sh BUILD_FOLDER CXX: prints the picture's size and how much of it is covered; fails if any step does.
set -euo pipefail
build=$1 compiler=$2
here=$(dirname -- "$(readlink -f -- "$0")")
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT

cmake --install "$build" --prefix "$folder/prefix" >"$folder/log"
cp -- "$here"/CMakeLists.txt "$here"/embedding.cpp "$folder"
# The program of docs/library.md, whose parts follow each other.
sed -n '/^```cpp$/,/^```$/p' "$here/../../docs/library.md" | grep -v '^```' >"$folder/library.cpp"
cmake -S "$folder" -B "$folder/build" -G Ninja -D CMAKE_PREFIX_PATH="$folder/prefix" -D CMAKE_CXX_COMPILER="$compiler" \
    -D CMAKE_BUILD_TYPE=Release >>"$folder/log" || { cat "$folder/log"; exit 1; }
cmake --build "$folder/build" >>"$folder/log" || { cat "$folder/log"; exit 1; }
! grep -rqF "$(dirname -- "$(dirname -- "$here")")/engine" "$folder/prefix/lib" --include='*.cmake' ||
    { echo "the installed CMake files name the source folder"; exit 1; }

# Every header stands by itself under nacre/: none names another that is not installed.
(cd "$folder/prefix/include" && find nacre -name '*.h' | sort | sed 's/.*/#include <&>/') >"$folder/headers.cpp"
count=$(wc -l <"$folder/headers.cpp")
((20 < count && count <= 40)) || { echo "$count headers are installed"; exit 1; }
! grep -rq '"engine/' "$folder/prefix/include" || { echo "an installed header names engine/"; exit 1; }
"$compiler" -std=c++20 -fsyntax-only -I"$folder/prefix/include" "$folder/headers.cpp"

# The interface is quick to read for people and compilers: at most 10 other headers, and none of Vulkan's.
"$compiler" -std=c++20 -M -I"$folder/prefix/include" -x c++ "$folder/prefix/include/nacre/renderer.h" |
    grep -oE '[^ ]+\.h\b' >"$folder/reached"
reached=$(grep -cE '/include/nacre/' "$folder/reached")
((1 < reached && reached <= 11)) || { echo "renderer.h reaches $((reached - 1)) headers"; exit 1; }
! grep -E 'vulkan' "$folder/reached" || { echo "renderer.h includes Vulkan's headers"; exit 1; }

# It says what it drew.
"$folder/build/library" >"$folder/said" || { echo "the program of docs/library.md failed"; exit 1; }
grep -q '^36 pictures$' "$folder/said" || { cat "$folder/said"; exit 1; }

printf '3\nwater\nO 0 0 0\nH 0.96 0 0\nH -0.24 0.93 0\n' >"$folder/water.xyz"
"$folder/build/embedding" "$folder/water.xyz" "$folder/water.ppm"
# With the driver of a package beside the program, where there is no other.
ln -s -- /usr/lib/chromium/libvk_swiftshader.so "$folder/build"
cp -- /usr/lib/chromium/vk_swiftshader_icd.json "$folder/build"
VK_DRIVER_FILES=/nonexistent VK_ICD_FILENAMES=/nonexistent "$folder/build/embedding" "$folder/water.xyz" "$folder/bundled.ppm"
[[ -s $folder/bundled.ppm ]] || exit 1
# The installed program draws the same: as many pixels are not black, but for the edges, which two by two samples widen.
"$folder/prefix/bin/nacre" render "$folder/water.xyz" -o "$folder/water.png" --zoom 1 --size 400x300 --supersample 1 --cache off \
    --stats "$folder/water.json"
pixels=$(python3 - "$folder/water.ppm" "$folder/water.json" <<'END'
import json, sys
data = open(sys.argv[1], "rb").read()[15:]
assert len(data) == 3 * 400 * 300, len(data)
pixels = sum(data[i:i + 3] != bytes(3) for i in range(0, len(data), 3))
covered = json.load(open(sys.argv[2]))["covered_pixels"]
assert covered > 10000 and covered <= pixels < 1.06 * covered, (pixels, covered)
print(pixels)
END
)
if "$folder/build/embedding" none.pdb "$folder/none.ppm" 2>"$folder/error"; then exit 1; fi
grep -q none.pdb "$folder/error"
echo "400 x 300, $pixels pixels covered"
