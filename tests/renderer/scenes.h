#pragma once
// The scenes and the device that the tests of the renderer share.

#include <gtest/gtest.h>

#include <cctype>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"
#include "engine/renderer.h"
#include "engine/scene/build/representation.h"
#include "tests/reference/layers.h"
#include "tests/support/device_paths.h"
#include "tests/support/test_data.h"

namespace nacre::test {

/// A molecule by name: "sample:dna", or a file of the test data (use NACRE_NEEDS_DATA(name) first).
inline Molecule molecule(const std::string& name) {
    if (name.starts_with("sample:")) return sampleMolecule(name.substr(7));
    return readMoleculeFile(dataFile(name));
}

/// A molecule's name as part of a test's: letters and digits alone.
inline std::string testName(std::string file) {
    for (char& c : file)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return file;
}

/// Gives a molecule an assembly "1" of copies of all of it, moved by so much each.
inline void addCopies(Molecule& m, const std::vector<glm::vec3>& places) {
    if (m.subchains.empty()) m.subchains = {"A"};
    m.assemblies = {{"1", "", {{}}}};
    for (std::uint32_t i = 0; i < m.subchains.size(); ++i) m.assemblies[0].parts[0].subchains.push_back(i);
    for (const glm::vec3& place : places) {
        glm::mat4x3 transform(1.0f);
        transform[3] = place;
        m.assemblies[0].parts[0].transforms.push_back(transform);
    }
}

inline Representation scene(const std::string& name, Style style) {
    const Molecule m = molecule(name);
    return represent(m, drawnAtoms(m), {style, ColorScheme::element});
}

/// Renderers that no test uses at the moment. Making one and compiling its pipelines takes longer than most tests draw.
class IdleRenderers : public testing::Environment {
public:
    std::unique_ptr<Renderer> take(Visibility visibility) {
        std::vector<std::unique_ptr<Renderer>>& idle = idle_[visibility];
        if (idle.empty()) return std::make_unique<Renderer>(DeviceOptions{true, "", visibility});
        std::unique_ptr<Renderer> renderer = std::move(idle.back());
        idle.pop_back();
        return renderer;
    }
    void give(Visibility visibility, std::unique_ptr<Renderer> renderer) {
        idle_[visibility].push_back(std::move(renderer));
    }
    void TearDown() override { idle_.clear(); }  // before the drivers go

private:
    std::map<Visibility, std::vector<std::unique_ptr<Renderer>>> idle_;
};
inline IdleRenderers* const idleRenderers =  // gtest's own
    static_cast<IdleRenderers*>(testing::AddGlobalTestEnvironment(new IdleRenderers));

/// A renderer on the driver that the environment names, with validation. Any message fails the test. It may have drawn
/// for another test before, unless it is to be fresh: for tests that change the environment, or ask what came first.
class ValidatedRenderer {
public:
    enum Age { any, fresh };
    explicit ValidatedRenderer(Visibility visibility, Age age = any)
        : visibility_(visibility),
          age_(age),
          renderer_(age == any ? idleRenderers->take(visibility)
                               : std::make_unique<Renderer>(DeviceOptions{true, "", visibility})),
          said_(renderer_->validationMessages().size()) {
        renderer_->setScene({});  // the scene of another test would keep its occlusion
    }
    ValidatedRenderer(Visibility visibility, const Representation& scene, Age age = any)
        : ValidatedRenderer(visibility, age) {
        renderer_->setScene(scene);
    }
    ValidatedRenderer(const ValidatedRenderer&) = delete;
    ~ValidatedRenderer() {
        const std::vector<std::string> messages = renderer_->validationMessages();
        for (std::size_t i = said_; i < messages.size(); ++i) ADD_FAILURE() << messages[i];
        if (age_ == any && !testing::Test::HasFailure()) idleRenderers->give(visibility_, std::move(renderer_));
    }
    Renderer* operator->() { return renderer_.get(); }

private:
    Visibility visibility_;
    Age age_;
    std::unique_ptr<Renderer> renderer_;
    std::size_t said_;
};

/// A renderer for each path, made when it is first asked for.
class PathRenderers {
public:
    ValidatedRenderer& operator[](Visibility visibility) {
        std::unique_ptr<ValidatedRenderer>& renderer = renderers_[visibility];
        if (!renderer) renderer = std::make_unique<ValidatedRenderer>(visibility);
        return *renderer;
    }
    void clear() { renderers_.clear(); }

private:
    std::map<Visibility, std::unique_ptr<ValidatedRenderer>> renderers_;
};

/// Cases that share a renderer for each path, so that the driver compiles its pipelines once and not once a case.
template <typename Case>
class SharedRenderers : public testing::TestWithParam<Case> {
protected:
    static ValidatedRenderer& sharedRenderer(Visibility visibility) { return renderers_[visibility]; }
    static ValidatedRenderer& sharedRenderer(Visibility visibility, const Representation& scene) {
        renderers_[visibility]->setScene(scene);
        return renderers_[visibility];
    }
    static void TearDownTestSuite() { renderers_.clear(); }

private:
    static inline PathRenderers renderers_;
};

inline RenderSettings settings(const Representation& r, std::uint32_t size, Projection projection,
                               glm::dvec3 rotation = {20, 30, 10}, double zoom = 1) {
    Camera camera{.projection = projection, .rotationDegrees = rotation, .zoom = zoom};
    RenderSettings s{.view = makeView(camera, r.radius, size, size)};
    s.occlusion.directions = 0;
    s.supersample = 1;
    return s;
}

/// sRGB's code of a linear channel; both 0..1. IEC 61966-2-1.
inline float coded(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

/// The first picture with its layers, which all others have to be to the bit.
struct FirstPicture {
    LayerPicture layers;
    Picture picture;

    void expectSame(ValidatedRenderer& renderer, const RenderSettings& settings, const std::string& what) {
        const LayerPicture l = renderer->layers(settings);
        const Picture p = renderer->render(settings);
        if (picture.rgba.empty()) layers = l, picture = p;
        EXPECT_TRUE(l.id == layers.id) << what;
        EXPECT_TRUE(l.z == layers.z) << what;
        EXPECT_TRUE(l.normal == layers.normal) << what;
        EXPECT_TRUE(l.occlusion == layers.occlusion) << what;
        EXPECT_TRUE(p.rgba == picture.rgba) << what;
    }
};

/// Colour and occlusion, which are the same to the bit on every path: those of the first.
struct PictureAndOcclusion {
    std::vector<float> rgba, occlusion;
};
inline PictureAndOcclusion sameOnEveryPath(PathRenderers& renderers, const Representation& scene,
                                           const RenderSettings& settings) {
    PictureAndOcclusion first;
    for (const Visibility visibility : devicePaths()) {
        ValidatedRenderer& renderer = renderers[visibility];
        renderer->setScene(scene);
        Picture p = renderer->render(settings);
        LayerPicture l = renderer->layers(settings);
        if (first.rgba.empty())
            first = {std::move(p.rgba), std::move(l.occlusion)};
        else {
            EXPECT_TRUE(p.rgba == first.rgba) << visibilityName(visibility);
            EXPECT_TRUE(l.occlusion == first.occlusion) << visibilityName(visibility);
        }
    }
    return first;
}

inline reference::Layers toReference(const LayerPicture& p) {
    reference::Layers l = reference::emptyLayers(p.width, p.height);
    l.id = p.id;
    l.z = p.z;
    for (std::size_t i = 0; i < p.id.size(); ++i) {
        l.nx[i] = p.normal[3 * i];
        l.ny[i] = p.normal[3 * i + 1];
        l.nz[i] = p.normal[3 * i + 2];
    }
    return l;
}

}  // namespace nacre::test
