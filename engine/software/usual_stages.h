#pragma once
// Stages of the tile passes for usual pictures: constants that most pictures leave alone have their values since the
// stage was built (shaders/common/usual.glsl), and their loops are unrolled, so that a driver has less to clean up.

#include <cstdint>

#include "engine/gpu/pipeline.h"
#include "engine/passes/scene_buffers.h"
#include "shaders/common/layout.h"

namespace nacre::passes {

struct UsualConstant {
    int id;
    std::uint32_t value;
};
inline constexpr UsualConstant kUsualConstants[] = {
    {layout::kPerspectiveId, 0}, {layout::kQuarterTurnsId, 0}, {layout::kWholeImageId, 1}, {layout::kClipId, 0},
    {layout::kCutId, 0},         {layout::kContoursId, 0},     {layout::kCopiesId, 0},     {layout::kWiresId, 0},
    {layout::kCapId, 0},         {layout::kFogId, 0},          {layout::kShadowId, 0},     {layout::kCopyColorsId, 0},
    {layout::kBlendColorsId, 0}, {layout::kTilesInBinId, 2},   {layout::kLanesId, 8},
};

/// Whether all that are set of these have their usual values. @param rims  outlines are usual
bool isUsual(const gpu::Specialization& constants, bool rims = false);

/// The stage of a scene: of spheres, with cylinders, with triangles, or of triangles alone.
#define NACRE_USUAL_STAGE(name, scene)                                                                             \
    ((scene).triangleCount > 0   ? (scene).sphereCount + (scene).cylinderCount > 0 ? shaders::name##TrianglesUsual \
                                                                                   : shaders::name##MeshesUsual    \
     : (scene).cylinderCount > 0 ? shaders::name##CylindersUsual                                                   \
                                 : shaders::name##SpheresUsual)

}  // namespace nacre::passes
