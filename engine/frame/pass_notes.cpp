#include "engine/frame/pass_notes.h"

#include "engine/frame/effects/outlines/outlines.h"
#include "engine/frame/effects/shadow/choice.h"
#include "engine/frame/effects/translucency/translucency.h"
#include "engine/frame/paths/paths.h"
#include "engine/scene/build/representation.h"

namespace nacre {
namespace {

// Each of three vertex invocations fetches the whole triangle; caches serve two of them.
constexpr std::uint32_t kTriangle = sizeof(Triangle) + 3 * sizeof(MeshVertex);
constexpr Fetch kPositions{sizeof(Sphere), sizeof(Cylinder), kTriangle};
constexpr Fetch kPlates{sizeof(Sphere), 0, kTriangle};
// A primitive's patch of the occlusion atlas follows from its number, and is not fetched.
constexpr Fetch kRecords{sizeof(Sphere) + sizeof(SphereLook), sizeof(Cylinder) + sizeof(CylinderLook),
                         kTriangle + 3 * sizeof(SphereLook)};
constexpr Fetch kRecordsOfPixel{kRecords.sphere, kRecords.cylinder, kRecords.triangle, true};

constexpr const char* kPrecisionPlates = "fp32: positions; no fragment arithmetic";
constexpr const char* kPrecisionHit = "fp32: positions, hit, depth (a half resolves 0.06 A at 100 A)";
constexpr const char* kPrecisionShade =
    "fp32: positions, hit, depth, atlas address; fp16 would do: normal, occlusion, light, colour";

/// Depth of a pass that writes the hit's own depth.
constexpr const char* kConservative =
    "gl_FragDepth is declared depth_greater: what the polygon hides is rejected early, the hit itself is tested late";

constexpr const char* kLate =
    "gl_FragDepth is declared depth_greater, which this driver does not honour: every fragment is shaded, then tested";

}  // namespace

const char* depthTimingName(DepthTiming timing) {
    switch (timing) {
        case DepthTiming::none:
            return "none";
        case DepthTiming::early:
            return "early";
        case DepthTiming::conservative:
            return "conservative";
        case DepthTiming::late:
            return "late";
    }
    return "";
}

PassNotes describePass(const graph::PassDecl& pass, bool conservative) {
    using graph::Verb;
    const bool shades = pass.has(Verb::samples);  // the occlusion atlas
    if (pass.name.starts_with(kTranslucentLayer))
        return {conservative ? DepthTiming::conservative : DepthTiming::late,
                pass.has(Verb::samples) ? "only what lies behind the layer before is kept; two layers need no sorting"
                : conservative          ? kConservative
                                        : kLate,
                {},
                {},
                kPrecisionHit};
    if (pass.name == kTranslucentRest)
        return {conservative ? DepthTiming::conservative : DepthTiming::late,
                "sums over what lies behind the last layer, in any order; opaque shapes hide a part", kPositions,
                kRecordsOfPixel, kPrecisionShade};
    if (pass.name == kOpaqueDepth)
        return {DepthTiming::late,
                "a triangle over the screen; depth for the tests of translucent layers",
                {},
                {},
                kPrecisionHit};
    if (pass.kind == graph::PassKind::compute && pass.name.starts_with("translucent"))
        return {
            DepthTiming::none,
            "the colours of a pixel's two nearest layers and sums over the rest stay in registers; lists are sorted "
            "from near to far",
            kPositions, kRecordsOfPixel, kPrecisionShade};
    if (pass.name.starts_with(kTranslucentColor) && pass.has(Verb::reads))
        return {DepthTiming::none,
                "rows of tiles; compute has shaded the layers, of which each pass reads one of three",
                {},
                {},
                "fp16: colour, opacity"};
    if (pass.name.starts_with(kTranslucentColor))
        return {pass.has(Verb::depthTest) ? DepthTiming::late : DepthTiming::none,
                "a triangle over the screen; opaque shapes hide a layer, or are seen through it",
                {},
                {},
                kPrecisionShade};
    if (pass.name.starts_with("lists: "))
        return {DepthTiming::none,
                "the primitives of each square of 16 x 16 pixels, sorted from near to far",
                kPositions,
                {},
                kPrecisionHit};
    if (pass.kind == graph::PassKind::compute && shades)
        return {DepthTiming::none,
                "the nearest depths of an edge pixel's samples stay in registers; each primitive that they see is "
                "shaded once",
                kPositions, kRecordsOfPixel, kPrecisionShade};
    if (pass.kind == graph::PassKind::compute)
        return {DepthTiming::none,
                "the nearest depth of a tile's pixels stays in registers; lists are sorted from near to far",
                kPositions, kPositions, kPrecisionHit};
    if (pass.name == kRimPass)
        return {DepthTiming::early, "depth is only tested; of the rims at a pixel MAX keeps the densest", kPositions,
                kPositions, kPrecisionHit};
    if (pass.has(Verb::depth) && (pass.has(Verb::reads) || pass.name == kDepthByNumbers))
        return {DepthTiming::late,
                "triangles over the screen; each covered pixel is shaded once, and its depth is kept for translucent "
                "layers",
                {},
                kRecordsOfPixel,
                kPrecisionShade};
    if (pass.has(Verb::depth)) {
        if (pass.name == kShadowPass)
            return {DepthTiming::conservative, kConservative, kPositions, kPositions, kPrecisionHit};
        if (!pass.has(Verb::color))
            return {DepthTiming::early,
                    "depth comes from the plate's corners; the shader has no output",
                    kPlates,
                    {},
                    kPrecisionPlates};
        return {conservative ? DepthTiming::conservative : DepthTiming::late, conservative ? kConservative : kLate,
                kPositions, shades ? kRecords : kPositions, shades ? kPrecisionShade : kPrecisionHit};
    }
    if (!pass.has(Verb::depthTest) && !shades && !pass.has(Verb::input))
        return {DepthTiming::none,
                "shaded edge pixels are drawn over the picture",
                {},
                {},
                "fp16: linear colour, coverage"};
    if (!pass.has(Verb::depthTest))
        return {DepthTiming::none,
                "triangles over the screen; each covered pixel is shaded once",
                {},
                kRecordsOfPixel,
                kPrecisionShade};
    if (shades)
        return {DepthTiming::early, "depth is only tested, so that a discard cannot delay it", kPositions, kRecords,
                kPrecisionShade};
    return {DepthTiming::early,
            "depth is only tested; outside the outline MIN's neutral value is written instead of a discard", kPositions,
            kPositions, kPrecisionHit};
}

}  // namespace nacre
