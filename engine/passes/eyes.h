#pragma once
// Stages of passes that draw two eyes' views at once.

#include <algorithm>

#include "engine/gpu/execute.h"
#include "shaders.h"

namespace nacre::passes {

/// @param name  of the pass @throws graph::GraphError if the stage draws one view alone
inline gpu::ShaderWords forEyes(gpu::ShaderWords plain, std::string_view name) {
    const auto found = std::ranges::find_if(
        shaders::forEyes, [&](const shaders::ForEyes& one) { return one.plain.data() == plain.data(); });
    if (found == shaders::forEyes.end())
        throw graph::GraphError("pass '" + std::string(name) + "': its shaders draw one view");
    return found->eyes;
}

/// The stage for the number of views in a draw call of the pass.
inline gpu::ShaderWords forViews(const gpu::PipelineContext& context, gpu::ShaderWords plain) {
    return context.views == 1 ? plain : forEyes(plain, context.pass);
}

}  // namespace nacre::passes
