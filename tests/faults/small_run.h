#pragma once

#include "tests/faults/fault_run.h"

namespace nacre::test {

struct Pictures {
    std::vector<float> picture, layers;
    friend bool operator==(const Pictures&, const Pictures&) = default;
};

/// A scene, its picture and its layers, as the command line would draw them.
class SmallRun {
public:
    explicit SmallRun(Visibility visibility) : scene_(scene("sample:glucose", Style::ballAndStick)) {
        options_.validate = true;
        options_.visibility = visibility;
        settings_ = settings(scene_, 48, Projection::orthographic);
        settings_.occlusion.directions = 3;
        settings_.occlusion.bytes = 1 << 20;  // coarse patches: it is done dozens of times
    }

    /// @param keep  the scene that is there, with its occlusion, from a run that failed later
    Pictures operator()(std::optional<Renderer>& renderer, bool keep = false) {
        if (!renderer) {
            sceneThere_ = false;
            renderer.emplace(options_);
        }
        if (!keep || !sceneThere_) {
            renderer->setScene({});  // the same scene would keep its buffers and occlusion
            renderer->setScene(scene_);
        }
        sceneThere_ = true;
        return {renderer->render(settings_).rgba, renderer->layers(settings_).rgba};
    }
    void startFrom(std::vector<std::byte> pipelineCache) { options_.pipelineCache = std::move(pipelineCache); }
    /// Of the scene that is there.
    Pictures smaller(Renderer& renderer) const {
        RenderSettings s = settings_;
        s.view.width = s.view.height = 24;
        return {renderer.render(s).rgba, renderer.layers(s).rgba};
    }

private:
    Representation scene_;
    DeviceOptions options_;
    RenderSettings settings_;
    bool sceneThere_ = false;
};

}  // namespace nacre::test
