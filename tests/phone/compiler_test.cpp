// A driver whose compiler is not thread-safe (tests/phone_layer ends the program where two threads are in it).

#include <gtest/gtest.h>

#include <memory>
#include <thread>
#include <vector>

#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"
#include "engine/renderer.h"
#include "engine/scene/build/representation.h"

namespace nacre::test {
namespace {

TEST(Compiler, IsEnteredByOneThreadAtATime) {
    DeviceOptions options{.validate = true};
    std::vector<std::unique_ptr<Renderer>> renderers;
    for (int i = 0; i < 2; ++i) renderers.push_back(std::make_unique<Renderer>(options));
    std::vector<std::thread> threads;
    for (const auto& renderer : renderers)
        threads.emplace_back([&renderer] {
            const Molecule molecule = sampleMolecule("glucose");
            const Representation r = represent(molecule, drawnAtoms(molecule), {});
            renderer->setScene(r);
            RenderSettings settings{.view = makeView(Camera{}, r.radius, 32, 32)};
            settings.occlusion.directions = 2;
            renderer->render(settings);
        });
    for (std::thread& thread : threads) thread.join();
    for (const auto& renderer : renderers) {
        EXPECT_GT(renderer->stats().pipelines, 1u);
        EXPECT_EQ(renderer->stats().device.capabilitySet, "no-subpass");
        for (const std::string& message : renderer->validationMessages()) ADD_FAILURE() << message;
    }
}

}  // namespace
}  // namespace nacre::test
