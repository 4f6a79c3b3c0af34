#pragma once
// Converts a request to a picture's description, and rejects options that requests may not use.

#include <string>
#include <utility>
#include <vector>

#include "app/picture/option_json.h"
#include "app/serve/serve_options.h"

namespace nacre::app {

class UnnamedFile;
class Uploads;

/// Keys and values of a query, in order.
using Query = std::vector<std::pair<std::string, std::string>>;

struct PictureRequest {
    PictureDescription description;  ///< complete; `output` is only a format, "picture.png"
    std::string molecule;            ///< key of the molecule when the request arrived; see moleculeKey()
    std::string identity;            ///< key of the picture
};

/// Limits for one picture.
constexpr std::uint64_t kMostServedSamples = std::uint64_t{1} << 24;  ///< 4096 x 4096
constexpr std::size_t kMostBodyBytes = std::size_t{64} << 20;

/// Whether requests may use this option: those that name files or the device belong to the server.
bool isServed(const Option& option);

/// @param query  option keys, with `input` and `format` (png, jpg, webp, tif, exr)
/// @param body   the request's body: a structure or a saved view; null: none @throws Problem
PictureRequest pictureRequest(const Query& query, const UnnamedFile* body, const ServeOptions& options,
                              const Uploads& uploads);

/// Key of the molecule of a complete description: by the names and current contents of all files read for it.
std::string moleculeKey(const PictureDescription& description);

/// The query of "4hhb_assembly-1_front-512x512.webp": PDB identifier or sample, then any number of assembly-N, model-N,
/// front, side or top (the camera), a style, a colour scheme; then a size. @returns the equivalent query; empty:
/// invalid name
Query queryOfName(const std::string& name);

}  // namespace nacre::app
