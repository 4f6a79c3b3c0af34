# Has spirv-opt's --loop-unroll unroll each loop whose number of turns it finds: sh unroll.sh SPIRV_DIS SPIRV_AS FILE.spv
set -e
"$1" "$3" | sed 's/\(OpLoopMerge .*\) None$/\1 Unroll/' > "$3.asm"
"$2" --target-env vulkan1.1 --preserve-numeric-ids "$3.asm" -o "$3"
rm "$3.asm"
