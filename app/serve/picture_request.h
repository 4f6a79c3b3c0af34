#pragma once
// From the words of a request to the description of a picture, and what a request must not ask for.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "app/picture/option_json.h"
#include "app/serve/serve_options.h"

namespace nacre::app {

/// Keys and values of a query, in its order.
using Query = std::vector<std::pair<std::string, std::string>>;

struct PictureRequest {
    PictureDescription description;  ///< complete; `output` names no file but the format, "picture.png"
    std::string molecule;            ///< text that is the same for the same molecule alone: content, and how it is read
    std::string identity;            ///< the same of the picture
};

/// Bounds of one picture.
constexpr std::uint64_t kMostServedSamples = std::uint64_t{1} << 24;  ///< 4096 x 4096
constexpr std::size_t kMostBodyBytes = std::size_t{64} << 20;

/// Whether a request may have this option: those that name files or the device are the server's.
bool isServed(const Option& option);

/// @param query  the options' own keys, with `input` and `format` (png, jpg, webp, tif, exr)
/// @param body   path of a file with the request's body: a structure or a saved view; empty: none
/// @param uploads  folder of what "upload:NAME" names
/// @throws Problem
PictureRequest pictureRequest(const Query& query, const std::string& body, const ServeOptions& options,
                              const std::string& uploads = {});

/// "4hhb_assembly-1_front-512x512.webp": PDB identifier or sample, then in any number assembly-N, model-N, front, side
/// or top (the camera), a style, a colour scheme; then a size. @returns what it means as a query; empty: no such name
Query queryOfName(const std::string& name);

}  // namespace nacre::app
