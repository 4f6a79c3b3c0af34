// Dependencies point one way: reads every #include of engine/ and app/, and knows which are allowed. Who adds an arrow
// adds it to the tables here, and to nobody's surprise.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

namespace nacre::test {
namespace {

namespace fs = std::filesystem;

struct Include {
    std::string file;    ///< path from the root: "engine/graph/plan.cpp"
    std::string header;  ///< as it is written
    bool system = false;
};

/// What a folder's files may include of the project besides the folder itself. The longest name that fits a file is
/// the one that holds. A name that ends in '/' is a folder with all in it; one that ends in "*.h" its headers alone.
struct Arrows {
    std::string from;
    std::vector<std::string> to;
};

// Plain values that every part of the engine speaks of: no layer.
const std::vector<std::string> kPlain = {
    "engine/error.h",        "engine/device_options.h",  "engine/debug_view.h", "engine/overlay.h",
    "engine/milliseconds.h", "engine/settings.h",        "engine/effects.h",    "engine/results.h",
    "engine/devices.h",      "engine/baked_occlusion.h", "engine/threads.h",    "engine/coded_picture.h",
    "engine/srgb.h"};

const std::vector<Arrows> kArrows = {
    {"engine/molecule/", {}},
    {"engine/volume/", {"engine/molecule/"}},
    {"engine/mesh/", {"engine/molecule/", "engine/simd/", "engine/volume/"}},
    {"engine/scene/", {"engine/mesh/", "engine/molecule/", "engine/volume/"}},
    {"engine/simd/", {}},
    {"engine/lists/", {"engine/scene/", "engine/simd/"}},
    {"engine/storage/", {}},
    {"engine/graph/", {}},
    {"engine/gpu/", {"engine/graph/", "engine/storage/"}},
    {"engine/passes/", {"engine/lists/", "engine/scene/", "engine/gpu/", "engine/graph/", "shaders/", "shaders.h"}},
    {"engine/tiles/", {"engine/passes/", "engine/scene/", "engine/gpu/", "engine/graph/", "shaders/", "shaders.h"}},
    {"engine/software/",
     {"engine/tiles/", "engine/occlusion/", "engine/passes/", "engine/lists/", "engine/scene/", "engine/simd/",
      "engine/gpu/", "engine/graph/", "shaders/", "shaders.h"}},
    {"engine/occlusion/",
     {"engine/software/software.h", "engine/tiles/", "engine/passes/", "engine/scene/", "engine/simd/", "engine/mesh/",
      "engine/gpu/", "engine/graph/", "engine/storage/", "shaders/", "shaders.h"}},
    {"engine/frame/",
     {"engine/software/software.h", "engine/tiles/", "engine/passes/", "engine/lists/", "engine/scene/", "engine/gpu/",
      "engine/graph/", "shaders/", "shaders.h"}},
    {"engine/frame/devices.cpp", {"engine/frame/", "engine/device_caps.h", "engine/gpu/", "engine/graph/"}},
    // The face tells of molecules and scenes, and one of its headers of plans; its sources are the renderer.
    {"engine/*.h", {"engine/molecule/", "engine/scene/"}},
    {"engine/device_caps.h", {"engine/graph/"}},
    {"engine/self_test.h", {"engine/graph/frame_caps.h"}},
    {"engine/", {"engine/"}},

    {"app/files/", {"engine/*.h", "engine/storage/"}},
    {"app/picture/", {"app/files/", "engine/*.h", "engine/molecule/", "engine/scene/"}},
    {"app/input/", {"app/picture/", "app/files/", "engine/*.h", "engine/molecule/", "engine/scene/", "engine/volume/"}},
    {"app/annotation/", {"app/picture/", "app/files/", "engine/*.h", "engine/molecule/", "engine/scene/"}},
    {"app/images/", {"app/picture/", "app/files/", "engine/*.h", "engine/storage/"}},
    {"app/drawing/",
     {"app/annotation/", "app/input/", "app/picture/", "app/files/", "engine/*.h", "engine/molecule/", "engine/scene/",
      "engine/volume/"}},
    {"app/mvs/",
     {"app/input/", "app/picture/", "app/files/", "engine/*.h", "engine/molecule/", "engine/scene/", "engine/volume/"}},
    {"app/download/",
     {"app/mvs/", "app/input/", "app/picture/", "app/files/", "engine/*.h", "engine/molecule/", "engine/storage/",
      "engine/volume/"}},
    {"app/download/molecule_sources.",
     {"app/mvs/", "app/download/", "app/viewer/", "app/drawing/", "app/input/", "app/picture/", "app/files/",
      "engine/*.h"}},
    {"app/viewer/",
     {"app/drawing/", "app/annotation/", "app/input/", "app/picture/", "app/files/", "engine/*.h", "engine/molecule/",
      "engine/scene/", "engine/volume/"}},
    {"app/viewer/kept_files.cpp",
     {"app/viewer/", "app/input/", "app/picture/", "app/files/", "engine/*.h", "engine/storage/"}},
    {"app/export/",
     {"app/images/", "app/picture/", "app/files/", "engine/*.h", "engine/mesh/", "engine/molecule/", "engine/scene/"}},
    {"app/movie/", {"app/images/", "app/picture/", "app/files/", "engine/*.h", "engine/scene/"}},
    {"app/panel/",
     {"app/viewer/", "app/drawing/", "app/annotation/", "app/input/", "app/picture/", "app/files/", "engine/*.h",
      "engine/molecule/", "engine/scene/", "engine/volume/"}},
    {"app/cli/",
     {"app/mvs/",
      "app/drawing/",
      "app/images/",
      "app/annotation/",
      "app/input/",
      "app/picture/",
      "app/files/",
      "app/movie/",
      "app/export/",
      "app/download/",
      "app/desktop/view_command.h",
      "app/serve/serve_options.h",
      "app/serve/server.h",
      "app/xr/xr_command.h",
      "engine/*.h",
      "engine/mesh/",
      "engine/molecule/",
      "engine/scene/",
      "engine/volume/",
      "nacre_commit.h"}},
    {"app/cli/plan_",
     {"app/cli/", "app/drawing/", "app/input/", "app/picture/", "app/files/", "app/download/", "engine/*.h",
      "engine/graph/", "engine/frame/"}},
    {"app/cli/stats.cpp",
     {"app/cli/", "app/picture/", "app/files/", "engine/*.h", "engine/scene/", "engine/frame/geometry.h"}},
    {"app/cli/options.cpp",
     {"app/cli/", "app/drawing/", "app/export/", "app/input/", "app/picture/", "app/files/", "engine/*.h",
      "engine/graph/capability_sets.h"}},
    // Its answers are commands': info, version.
    {"app/serve/",
     {"app/cli/commands.h", "app/drawing/", "app/download/", "app/images/", "app/movie/stop_request.h", "app/input/",
      "app/picture/", "app/files/", "engine/*.h", "engine/molecule/", "engine/storage/disk_cache.h"}},
    {"app/python/",
     {"app/download/", "app/drawing/", "app/export/", "app/movie/", "app/images/", "app/annotation/", "app/input/",
      "app/picture/", "app/files/", "engine/*.h", "engine/molecule/", "engine/scene/", "engine/volume/"}},
    {"app/desktop/",
     {"app/mvs/", "app/viewer/", "app/panel/", "app/download/", "app/drawing/", "app/images/", "app/annotation/",
      "app/input/", "app/picture/", "app/files/", "app/apple/mac/opened_files.h", "engine/*.h", "engine/molecule/",
      "engine/scene/"}},
    {"app/xr/",
     {"app/viewer/", "app/download/molecule_sources.h", "app/movie/stop_request.h", "app/picture/", "app/files/",
      "engine/*.h", "engine/scene/view/"}},
    {"app/phone/",
     {"app/viewer/", "app/panel/", "app/download/", "app/input/", "app/picture/", "app/files/", "engine/*.h"}},
    {"app/android/",
     {"app/phone/", "app/viewer/", "app/panel/", "app/download/", "app/annotation/", "app/picture/", "app/files/",
      "engine/*.h"}},
    {"app/apple/",
     {"app/phone/", "app/viewer/", "app/panel/", "app/download/", "app/annotation/", "app/picture/", "app/files/",
      "engine/*.h"}},
    {"app/apple/mac/", {"app/desktop/view_command.h"}},
};

/// Libraries that few may know: the beginning of a header's name, and who.
const std::vector<Arrows> kLibraries = {
    {"vulkan/vulkan_core.h", {"engine/", "app/"}},  // enums and handles
    {"vulkan/",
     {"engine/gpu/", "engine/passes/", "engine/occlusion/", "engine/frame/", "engine/renderer",
      "app/android/surface.cpp", "app/desktop/window.cpp", "app/apple/ios/metal_surface.mm"}},
    {"GLFW/", {"app/desktop/window.cpp"}},
    {"openxr/", {"app/xr/calls.h"}},
    {"httplib.h", {"app/serve/client_stream.h", "app/serve/http_server"}},
    {"CLI/", {"app/cli/command_parser.cpp"}},
    {"OpenImageIO/", {}},
    {"jpeglib.h", {"app/images/image_jpeg.cpp"}},
    {"tiffio.h", {}},
    {"OpenEXR/", {"app/images/image_exr.cpp"}},
    {"webp/", {"app/images/image_webp.cpp"}},
    {"png.h", {"app/movie/animated_png.cpp", "app/images/image_png.cpp"}},
    {"libdeflate.h", {"app/images/image_png.cpp"}},
    {"gif_lib.h", {"app/movie/gif.cpp"}},
    {"ft2build.h", {"app/annotation/painter.cpp", "app/annotation/shaping."}},
    {"hb.h", {"app/annotation/"}},
    {"fribidi", {}},
    {"curl/", {"app/download/http.cpp"}},
    {"imgui", {"app/panel/"}},
    {"gemmi/", {"engine/molecule/", "engine/volume/"}},
    {"zip.h", {"app/mvs/archive.cpp"}},
    {"nlohmann/", {"app/"}},
    {"pybind11/", {"app/python/module.cpp", "app/python/interrupt."}},
};

bool startsWith(const std::string& text, const std::string& beginning) { return text.rfind(beginning, 0) == 0; }

/// Whether a name of the tables stands for a file.
bool covers(const std::string& name, const std::string& file) {
    if (name.ends_with("*.h")) {
        const std::string folder = name.substr(0, name.size() - 3);
        return startsWith(file, folder) && file.ends_with(".h") && file.find('/', folder.size()) == std::string::npos;
    }
    return startsWith(file, name);
}

/// Characters that a name fixes: the more, the closer it fits.
std::size_t closeness(const std::string& name) { return name.ends_with("*.h") ? name.size() - 2 : name.size(); }

bool allowedOfProject(const Include& include) {
    if (std::ranges::find(kPlain, include.header) != kPlain.end() && startsWith(include.file, "engine/")) return true;
    const Arrows* arrows = nullptr;
    for (const Arrows& a : kArrows)
        if (covers(a.from, include.file) && (!arrows || closeness(a.from) > closeness(arrows->from))) arrows = &a;
    if (!arrows) return false;
    if (arrows->from.ends_with("/") && arrows->from != "engine/" && startsWith(include.header, arrows->from))
        return true;  // its own folder
    return std::any_of(arrows->to.begin(), arrows->to.end(),
                       [&](const std::string& to) { return covers(to, include.header); });
}

bool allowedOfLibraries(const Include& include) {
    for (const Arrows& library : kLibraries)
        if (startsWith(include.header, library.from))
            return std::any_of(library.to.begin(), library.to.end(),
                               [&](const std::string& who) { return startsWith(include.file, who); });
    return true;
}

/// A folder within one that is named is the same layer: molecule/formats/ and molecule/.
bool allowed(const Include& include) {
    return include.system ? allowedOfLibraries(include) : allowedOfProject(include);
}

std::vector<Include> findIncludes(const fs::path& root) {
    static const std::regex kLine(R"re(^\s*#\s*(?:include|import)\s*(["<])([^">]+)[">])re");
    std::vector<Include> includes;
    for (const char* top : {"engine", "app"})
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / top)) {
            const std::string kind = entry.path().extension().string();
            if (kind != ".h" && kind != ".cpp" && kind != ".mm") continue;
            std::ifstream stream(entry.path());
            for (std::string line; std::getline(stream, line);)
                if (std::smatch match; std::regex_search(line, match, kLine))
                    includes.push_back({fs::relative(entry.path(), root).generic_string(), match[2], match[1] == "<"});
        }
    return includes;
}

TEST(House, EveryIncludePointsTheRightWay) {
    const std::vector<Include> includes = findIncludes(NACRE_SOURCE_DIR);
    ASSERT_GT(includes.size(), 1000u);
    for (const Include& include : includes)
        EXPECT_TRUE(allowed(include)) << include.file << " includes " << include.header;
}

TEST(House, WhatPointsTheWrongWayIsNoticed) {
    for (const Include& wrong :
         {Include{"engine/graph/plan.cpp", "engine/gpu/execute.h"}, Include{"engine/renderer.h", "engine/gpu/device.h"},
          Include{"app/cli/stats.cpp", "engine/gpu/device.h"}, Include{"app/desktop/window.h", "app/cli/options.h"},
          Include{"app/panel/panel.cpp", "GLFW/glfw3.h", true}})
        EXPECT_FALSE(allowed(wrong)) << wrong.file << " -> " << wrong.header;
}

}  // namespace
}  // namespace nacre::test
