#!/bin/sh
# Keeps the empty function countFragment() (common/count.glsl) of a module as a call when functions are inlined.
# usage: keep_counter.sh MODULE
set -eu
spirv-dis "$1" | sed 's/^\( *%countFragment_ = OpFunction %void\) None /\1 DontInline /' | spirv-as --target-env vulkan1.1 - -o "$1.kept"
mv -f -- "$1.kept" "$1"
