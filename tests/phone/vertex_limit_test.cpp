// Render passes with more vertex outputs than Mali has memory for end the program here (tests/phone_layer/vertices.h):
// no frame and no bake has one, whatever the limit.

#include <cstdlib>

#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

bool onArm() {
    const std::string_view phone = std::getenv("NACRE_PHONE");
    return phone == "mali" || phone == "android";
}

/// The phone's limit, for as long as this lives.
struct PhoneLimit {
    explicit PhoneLimit(std::uint64_t bytes) { setenv("NACRE_PHONE_VERTEX_BYTES", std::to_string(bytes).c_str(), 1); }
    ~PhoneLimit() { unsetenv("NACRE_PHONE_VERTEX_BYTES"); }
};

std::vector<Visibility> pathsOfArm() {
    std::vector<Visibility> paths{Visibility::encoded, Visibility::fragdepth, Visibility::deferred};
    if (std::string_view(std::getenv("NACRE_PHONE")) == "mali") paths.push_back(Visibility::rasterOrder);
    return paths;
}

TEST(VertexLimitOfThePhone, EndsAProgramThatGoesBeyondIt) {
    // Without this, silence in the other tests would prove nothing.
    if (!onArm()) GTEST_SKIP() << "no phone of Arm's";
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    EXPECT_DEATH(
        {
            const PhoneLimit phone(20'000);
            Renderer renderer(DeviceOptions{false, "", Visibility::encoded});
            const Representation r = scene("sample:dna", Style::spacefill);
            renderer.setScene(r);
            renderer.render(settings(r, 64, Projection::orthographic));
        },
        "more than 20000 bytes of vertex outputs");
}

TEST(VertexLimitOfThePhone, HoldsForEveryFrame) {
    if (!onArm()) GTEST_SKIP() << "no phone of Arm's";
    constexpr std::uint64_t kScreen = 512;  // a few triangles over the screen
    for (const Style style : {Style::spacefill, Style::ballAndStick, Style::cartoon}) {
        const Representation r = scene("sample:dna", style);
        for (const Visibility path : pathsOfArm()) {
            ValidatedRenderer renderer(path, r);
            for (const std::uint64_t most : {10'000u, 60'000u}) {
                const PhoneLimit phone(most + kScreen);
                RenderSettings s = settings(r, 64, Projection::orthographic);
                s.tuning.mostVertexBytes = most;
                renderer->render(s);
                renderer->layers(s);
                renderer->atomAt(s, 32, 32, 0);
                s.effects.shadow.strength = 0.5;
                s.effects.halos.width = 2;
                s.effects.contours = {1, 1.5, 3};
                renderer->render(s);
                RenderSettings both = settings(r, 64, Projection::perspective);
                const double eye = both.view.eyeDistance;
                both.view = paired(fromAside(both.view, -2, eye), fromAside(both.view, 2, eye));
                both.tuning = s.tuning;
                renderer->renderEyes(both);
            }
        }
    }
}

// More than the real limit in one pass: 1.3 million spheres are 83 MB of plates and 166 MB of impostors.
TEST(VertexLimitOfThePhone, HoldsForAMillionSpheresAndTheirBake) {
    if (!onArm()) GTEST_SKIP() << "no phone of Arm's";
    Representation r;
    constexpr int kSide = 109;
    for (int x = 0; x < kSide; ++x)
        for (int y = 0; y < kSide; ++y)
            for (int z = 0; z < kSide; ++z) {
                r.spheres.push_back({glm::vec3(x, y, z) - glm::vec3((kSide - 1) / 2.0f), 0.7f});
                r.sphereLooks.push_back({0xff2040e0u + static_cast<std::uint32_t>(x), 1});
            }
    r.radius = 100;
    r.drawnAtoms = static_cast<std::uint32_t>(r.spheres.size());
    ValidatedRenderer renderer(Visibility::automatic, r);
    RenderSettings s = settings(r, 64, Projection::orthographic);
    s.occlusion.directions = 2;
    const Picture picture = renderer->render(s);
    EXPECT_EQ(picture.rgba[4 * (32 * 64 + 32) + 3], 1);
    const auto told = [](ValidatedRenderer& by, const char* what) {
        for (const Decision& decision : by->decisions())
            if (decision.what == what) return decision.how + ": " + decision.why;
        return std::string();
    };
    const std::string path = told(renderer, "path");
    EXPECT_TRUE(path.starts_with("tiles: vertex outputs would take ") &&
                path.ends_with(" render passes: compute draws from lists instead"))
        << path;
    // As by triangles, in several render passes.
    ValidatedRenderer triangles(Visibility::fragdepth, r);
    EXPECT_EQ(triangles->render(s).rgba, picture.rgba);
    const std::string fit = told(triangles, "vertex outputs");
    EXPECT_NE(fit.find("render passes without plates: they would be"), std::string::npos) << fit;
    EXPECT_NE(fit.find("a render pass gets at most 150 MB"), std::string::npos) << fit;
}

}  // namespace
}  // namespace nacre::test
