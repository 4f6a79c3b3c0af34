// Reading in raster order goes by two names, of which drivers may have either.

#include "tests/faults/fault_run.h"

namespace nacre::test {
namespace {

constexpr const char* kName = VK_EXT_RASTERIZATION_ORDER_ATTACHMENT_ACCESS_EXTENSION_NAME;
constexpr const char* kNameBefore = VK_ARM_RASTERIZATION_ORDER_ATTACHMENT_ACCESS_EXTENSION_NAME;

/// Devices that are made while this lives lack these.
struct Hidden {
    explicit Hidden(std::set<std::string> names) { faults::hideExtensions(std::move(names)); }
    ~Hidden() { faults::hideExtensions({}); }
};

std::vector<std::uint32_t> idsBy(Visibility path) {
    const Representation molecule = scene("sample:glucose", Style::ballAndStick);
    ValidatedRenderer renderer(path, molecule, ValidatedRenderer::fresh);
    return renderer->layers(settings(molecule, 64, Projection::orthographic)).id;
}

TEST(RasterOrder, GoesByEitherName) {
    const std::vector<std::uint32_t> ids = idsBy(Visibility::encoded);
    for (const char* hidden : {kName, kNameBefore}) {
        const Hidden without({hidden});
        EXPECT_EQ(idsBy(Visibility::rasterOrder), ids) << hidden;
    }
    const Hidden both({kName, kNameBefore});
    EXPECT_THROW(idsBy(Visibility::rasterOrder), Error);
}

}  // namespace
}  // namespace nacre::test
