#pragma once
// Capabilities that decide how a frame is drawn: of a real device or a named set.

#include <cstdint>
#include <string>

#include "engine/device_options.h"
#include "engine/graph/encoded_format.h"
#include "engine/graph/plan.h"

namespace nacre::graph {

/// Kinds of GPU by how they handle geometry.
enum class DeviceKind : std::uint8_t {
    tiler,      ///< renders tile by tile in on-chip memory
    layered,    ///< Vulkan on top of another API: MoltenVK, KosmicKrisp
    immediate,  ///< no tile memory
    software,   ///< a CPU draws: triangles cost more than fragments
};

/// For the tile path. The default is the least phone's.
struct TileCaps {
    bool texels = false;               ///< texel buffers can hold whole streams
    std::uint32_t lanes = 0;           ///< of the subgroup that draws a tile; 0: a workgroup does by shared memory
    bool lists = true;                 ///< compute makes the lists of tiles faster than the host
    std::uint32_t entries = 1u << 23;  ///< memory for such lists: of 12 bytes each; more are drawn in several rounds
    bool shade = false;                ///< compute shading is faster than drawing fragments
    bool drawsEdges = false;           ///< draws edges from the tile lists
    /// Most entries of a tile's list. lavapipe 22.3 allows an invocation 65,535 loop iterations in total, then ends its
    /// loops silently. Entries take one iteration each, and chunks as many again.
    std::uint32_t longestList = 28000;
    /// As above with samples at edges: a subgroup may go through a list several times.
    std::uint32_t longestListOfEdges = 6000;
};

/// The path that a self-test found to be right and fastest.
struct TestedPath {
    Visibility visibility = Visibility::automatic;  ///< automatic: none was tested
    std::string why;
    bool tilesFail = false;  ///< the test found pictures by compute wrong
};

struct FrameCaps {
    PlanCaps plan;
    DeviceKind kind = DeviceKind::immediate;
    EncodedFormat encoded{};  ///< for images
    TileCaps tiles{};
    bool blendsFloats = false;  ///< can blend colour attachments with 32 bits per channel
    std::string lacksRasterOrder = "it does not read its own attachments in order";  ///< why not, if it does not
    std::string lacksDensityMaps =
        "it is unknown whether the driver takes fragment density maps";  ///< why it takes none
    // The user's options, and the result of a self-test:
    Visibility visibility = Visibility::automatic;
    Multisampling multisampling = Multisampling::automatic;
    TestedPath tested{};
};

}  // namespace nacre::graph
