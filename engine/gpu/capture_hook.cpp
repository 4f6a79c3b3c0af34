#include "engine/gpu/capture_hook.h"

#include "engine/error.h"

#ifdef NACRE_RENDERDOC
#include <dlfcn.h>
#include <renderdoc_app.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>
#endif

namespace nacre::gpu {

#ifdef NACRE_RENDERDOC

namespace {

constexpr const char* kLibrary = "librenderdoc.so";
constexpr const char* kLayer = "VK_LAYER_RENDERDOC_Capture";
constexpr const char* kEnable = "ENABLE_VULKAN_RENDERDOC_CAPTURE";  // required by the layer's manifest

using Api = RENDERDOC_API_1_4_0;
Api& toApi(void* api) { return *static_cast<Api*>(api); }

bool loadedHere = false;  // by us, not by a launcher

}  // namespace

bool CaptureHook::built() { return true; }

void CaptureHook::load(bool wanted) {
    // Never unloaded: RenderDoc has hooks in the process by now.
    void* library = dlopen(kLibrary, RTLD_NOW | RTLD_NOLOAD);
    launched_ = library && !loadedHere;
    if (!library && !wanted) return;
    if (!library) {
        library = dlopen(kLibrary, RTLD_NOW);
        loadedHere = true;
    }
    if (!library) throw Error("cannot capture", "RenderDoc", std::string(dlerror()) + " (Debian: librenderdoc)");
    const auto getApi = reinterpret_cast<pRENDERDOC_GetAPI>(dlsym(library, "RENDERDOC_GetAPI"));
    void* api = nullptr;
    if (!getApi || getApi(eRENDERDOC_API_Version_1_4_0, &api) != 1) {
        if (!wanted) return;
        throw Error("cannot capture", kLibrary, "this RenderDoc is older than 1.4");
    }
    api_ = api;
    if (!std::getenv(kEnable)) setenv(kEnable, "1", 1);
    // F12 belongs to the viewer, and the overlay would draw into the picture.
    toApi(api_).SetCaptureKeys(nullptr, 0);
    toApi(api_).SetFocusToggleKeys(nullptr, 0);
    toApi(api_).MaskOverlayBits(eRENDERDOC_Overlay_None, eRENDERDOC_Overlay_None);
}

void CaptureHook::checkLayer(const vk::raii::Context& context) {
    const auto layers = context.enumerateInstanceLayerProperties();
    if (std::none_of(layers.begin(), layers.end(),
                     [](const auto& l) { return std::string_view(l.layerName.data()) == kLayer; }))
        throw Error("cannot capture", kLayer,
                    "Vulkan does not know RenderDoc's layer (renderdoccmd vulkanlayer --register --user)");
}

void CaptureHook::begin(vk::Instance instance, const std::string& stem) {
    if (!loaded()) throw Error("cannot capture", "", "RenderDoc was not loaded before the device was made");
    if (!stem.empty()) toApi(api_).SetCaptureFilePathTemplate(stem.c_str());
    instance_ = RENDERDOC_DEVICEPOINTER_FROM_VKINSTANCE(static_cast<VkInstance>(instance));
    toApi(api_).StartFrameCapture(instance_, nullptr);
}

std::string CaptureHook::end() {
    const bool whole = instance_ && toApi(api_).EndFrameCapture(instance_, nullptr) == 1;
    instance_ = nullptr;
    const std::uint32_t count = toApi(api_).GetNumCaptures();
    std::uint32_t length = 0;
    if (!whole || count == 0 || !toApi(api_).GetCapture(count - 1, nullptr, &length, nullptr) || length == 0)
        throw Error("cannot capture", "", "RenderDoc recorded nothing (is the disk full, or its layer disabled?)");
    std::string file(length, '\0');
    toApi(api_).GetCapture(count - 1, file.data(), &length, nullptr);
    file.resize(std::string_view(file.c_str()).size());  // the reported length includes the terminating zero
    return file;
}

CaptureHook::~CaptureHook() {
    if (instance_) toApi(api_).DiscardFrameCapture(instance_, nullptr);
}

#else

bool CaptureHook::built() { return false; }

void CaptureHook::load(bool wanted) {
    if (wanted)
        throw Error("cannot capture", "",
                    "this program was built without RenderDoc's header (Debian: librenderdoc-dev, then build again)");
}

void CaptureHook::checkLayer(const vk::raii::Context&) {}

void CaptureHook::begin(vk::Instance, const std::string&) { load(true); }

std::string CaptureHook::end() { return {}; }

CaptureHook::~CaptureHook() = default;

#endif

}  // namespace nacre::gpu
