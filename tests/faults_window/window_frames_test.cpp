// Frames for a window that nobody sees (VK_EXT_headless_surface, which SwiftShader has and lavapipe 22.3 has not;
// tests/desktop draws into real windows there).

#include "engine/error.h"
#include "tests/faults/fault_run.h"
#include "tests/support/headless_surface.h"

namespace nacre::test {
namespace {

using Quality = WindowFrame::Quality;

int surfaces = 0;

DeviceOptions windowOptions(Visibility visibility, Multisampling samples = Multisampling::automatic) {
    DeviceOptions options;
    options.multisampling = samples;
    options.validate = true;
    options.visibility = visibility;
    options.surface = headlessSurface();
    options.surface.create = [create = options.surface.create](VkInstance instance) {
        ++surfaces;
        return create(instance);
    };
    return options;
}

Overlay triangle() {
    Overlay overlay;
    overlay.vertices = {{5, 5, 0, 0, 0xff0000ff}, {60, 5, 0, 0, 0xff00ff00}, {5, 60, 0, 0, 0xffff0000}};
    overlay.indices = {0, 1, 2};
    overlay.batches = {{0, 0, 1000, 1000, 0, 3}, {-5, 10, 20, 20, 0, 3}, {50, 50, 40, 40, 0, 3}};
    return overlay;
}

TEST(WindowFrames, EveryKindOfFrameByEveryPathIsValid) {
    const Representation r = scene("sample:glucose", Style::ballAndStick);
    for (const Visibility path : devicePaths()) {
        Renderer renderer(windowOptions(path));
        const Overlay overlay = triangle();
        renderer.setOverlayGlyphs({2, 2, {255, 0, 255, 255}});
        RenderSettings s = settings(r, 96, Projection::orthographic);
        renderer.setScene({});  // nothing there yet
        // The surface has a size of its own: what was made for another is not drawn.
        EXPECT_EQ(renderer.present(s, {}), FrameOutcome::resized);
        const PixelSize size = renderer.windowSize();
        ASSERT_GT(size.width, 96u);
        Camera camera;
        s.view = makeView(camera, r.radius, size.width, size.height);
        EXPECT_EQ(renderer.present(s, {}), FrameOutcome::shown);
        renderer.setScene(r);
        s.occlusion.directions = 4;
        std::uint64_t shown = 1;
        for (int i = 0; i < 2; ++i) {
            renderer.advanceOcclusion(s, 0.1);
            for (const WindowFrame& frame :
                 {WindowFrame{}, WindowFrame{Quality::live, 0.5, 1, 0, &overlay},
                  WindowFrame{Quality::refined, 1, 16, 0, nullptr}, WindowFrame{Quality::refined, 1, 16, 1, &overlay},
                  WindowFrame{Quality::kept, 1, 1, 0, &overlay}, WindowFrame{Quality::live, 1, 1, 0, &overlay}}) {
                ASSERT_EQ(renderer.present(s, frame), FrameOutcome::shown);
                ++shown;
            }
        }
        for (std::size_t view = 1; path == Visibility::encoded && view < debugViewNames().size(); ++view) {
            s.debug = static_cast<DebugView>(view);
            ASSERT_EQ(renderer.present(s, {Quality::live, 0.5, 1, 0, &overlay}), FrameOutcome::shown);
            ++shown;
        }
        s.debug = DebugView::none;
        EXPECT_EQ(renderer.stats().windowFrames, shown);
        // A sample that does not follow on those that are there is none of this picture's.
        EXPECT_EQ(renderer.present(s, {Quality::refined, 1, 16, 7, nullptr}), FrameOutcome::resized);
        // The window goes and comes back, as on a phone.
        const int before = surfaces;
        renderer.releaseWindow();
        EXPECT_EQ(renderer.present(s, {}), FrameOutcome::shown);
        EXPECT_EQ(surfaces, before + 1);
        // Pictures for files in between.
        EXPECT_EQ(renderer.render(s).width, size.width);
        EXPECT_EQ(renderer.present(s, {}), FrameOutcome::shown);
        for (const std::string& message : renderer.validationMessages()) ADD_FAILURE() << message;
    }
}

TEST(WindowFrames, TwoEyesByEveryPathAreValid) {
    const Representation r = scene("sample:glucose", Style::ballAndStick);
    for (const Visibility path : devicePaths()) {
        Renderer renderer(windowOptions(path));
        renderer.setScene(r);
        RenderSettings s = settings(r, 96, Projection::perspective);
        EXPECT_EQ(renderer.present(s, {}), FrameOutcome::resized);
        const PixelSize size = renderer.windowSize();
        s.view = makeView(Camera{.projection = Projection::perspective}, r.radius, size.width, size.height);
        const Overlay overlay = triangle();
        for (const bool beside : {true, false}) {
            View middle = s.view;
            if (beside) middle.width /= 2;
            std::array<WindowEye, 2> eyes;
            eyes[0].view = fromAside(middle, -0.5, middle.eyeDistance);
            eyes[1].view = fromAside(middle, 0.5, middle.eyeDistance);
            if (beside) eyes[1].x = static_cast<std::int32_t>(middle.width);
            if (!beside) eyes[0].channels = {{{1, 0, 0}, {0, 0, 0}, {0, 0, 0}}};
            for (const bool together : {true, false}) {
                if (together) eyes[0].view = paired(eyes[0].view, eyes[1].view);
                if (!together) eyes[0].view.other.reset();
                for (WindowFrame frame : {WindowFrame{}, WindowFrame{Quality::live, 0.5, 1, 0, &overlay},
                                          WindowFrame{Quality::refined, 1, 16, 0, nullptr},
                                          WindowFrame{Quality::refined, 1, 16, 1, &overlay},
                                          WindowFrame{Quality::kept, 1, 1, 0, &overlay}}) {
                    frame.eyes = eyes;
                    ASSERT_EQ(renderer.present(s, frame), FrameOutcome::shown);
                }
            }
        }
        for (const std::string& message : renderer.validationMessages()) ADD_FAILURE() << message;
    }
    haveSmallWindows();
}

TEST(WindowFrames, RestThroughALensTakesNoPassMore) {
    const Representation r = scene("sample:glucose", Style::ballAndStick);
    Renderer renderer(windowOptions(Visibility::encoded));
    renderer.setScene(r);
    RenderSettings s = settings(r, 96, Projection::perspective);
    renderer.present(s, {});
    Camera camera;
    s.view = makeView(camera, r.radius, renderer.windowSize().width, renderer.windowSize().height);
    s.effects.depthOfField.strength = 0.1;
    EXPECT_EQ(renderer.present(s, {}), FrameOutcome::shown);
    for (std::uint32_t i = 0; i < 64; ++i)
        ASSERT_EQ(renderer.present(s, {Quality::refined, 1, 64, i, nullptr}), FrameOutcome::shown);
    EXPECT_EQ(renderer.present(s, {Quality::kept, 1, 1, 0, nullptr}), FrameOutcome::shown);
    for (const std::string& message : renderer.validationMessages()) ADD_FAILURE() << message;
}

TEST(WindowFrames, FourSamplesInMotionAreValidUnderAnOverlayAndAtAnySize) {
    const Representation r = scene("sample:glucose", Style::ballAndStick);
    {
        Renderer renderer(windowOptions(Visibility::fragdepth, Multisampling::four));
        const Overlay overlay = triangle();
        renderer.setOverlayGlyphs({2, 2, {255, 0, 255, 255}});
        renderer.setScene(r);
        RenderSettings s = settings(r, 96, Projection::orthographic);
        renderer.present(s, {});
        Camera camera;
        s.view = makeView(camera, r.radius, renderer.windowSize().width, renderer.windowSize().height);
        for (const double contours : {0.0, 2.0})  // which have one sample
            for (const WindowFrame& frame :
                 {WindowFrame{}, WindowFrame{Quality::live, 1, 1, 0, &overlay},
                  WindowFrame{Quality::live, 0.5, 1, 0, &overlay}, WindowFrame{Quality::refined, 1, 16, 0, &overlay},
                  WindowFrame{Quality::kept, 1, 1, 0, &overlay}}) {
                s.effects.contours.width = contours;
                ASSERT_EQ(renderer.present(s, frame), FrameOutcome::shown);
            }
        for (const std::string& message : renderer.validationMessages()) ADD_FAILURE() << message;
    }
}

TEST(WindowFrames, AMissingExtensionIsAnError) {
    DeviceOptions options;
    options.surface.instanceExtensions = {"VK_KHR_no_such_surface"};
    options.surface.create = [](VkInstance) { return VkSurfaceKHR{}; };
    EXPECT_THROW(Renderer{options}, Error);
}

}  // namespace
}  // namespace nacre::test
