#pragma once
// Drawing for the Python module: the options of a picture, and one renderer for all threads.

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/drawing/drawing.h"
#include "app/images/image_file.h"
#include "app/movie/camera_path.h"
#include "app/python/colors.h"
#include "engine/molecule/molecule.h"
#include "engine/results.h"

namespace nacre::python {

/// A molecule with the names of its inputs, for selections and messages. Threads may share it.
struct Structure {
    std::shared_ptr<const Molecule> molecule;
    std::vector<std::string> inputs;                     ///< one, or several drawn together
    std::vector<std::string> warnings = {}, notes = {};  ///< from opening
    app::InputOptions reading = {};                      ///< how it was read: model, trajectory
    /// The structure's scene, kept between pictures, for one thread at a time.
    struct Kept {
        std::mutex turn;
        app::Drawing drawing;
        Colors colors;  ///< of the drawing's scene
    };
    std::shared_ptr<Kept> kept = std::make_shared<Kept>();
};

struct Drawn {
    Picture picture;
    std::optional<CodedPicture> codes;  ///< instead of the picture, if 8 bits per channel are enough
    app::PictureFormat format;          ///< file format of the options
    std::vector<std::string> warnings;  ///< of the scene
};

/// Opens files, samples or downloads, as `nacre render INPUT...`. @param options  JSON: such as format, model, fit
/// @throws app::UsageError, Error
Structure openInputs(const std::vector<std::string>& inputs, const std::string& options);
/// Opens a file's bytes. @param name  for messages, and a hint to the format
Structure openBytes(const std::string& name, std::string bytes, const std::string& options);

/// Interactions of `nacre info --interactions --json`. @param options  JSON: such as interactions, interaction_rules
/// @throws app::UsageError, Error
nlohmann::ordered_json interactions(const Structure& structure, const std::string& options);

/// Draws with the shared renderer, one thread after another.
/// @param options  JSON, keys as in `nacre render` @throws app::UsageError, Error
Drawn draw(const Structure& structure, const std::string& options, const Colors& colors);
/// Draws a structure with several sets of options, each picture while the previous one is copied. All use one device.
/// @returns the first pictures, at least one; stops once they take 32 MiB
std::vector<Drawn> drawAll(const Structure& structure, const std::vector<std::string>& options, const Colors& colors);
LayerPicture drawLayers(const Structure& structure, const std::string& options, const Colors& colors,
                        std::vector<std::string>& warnings);

/// Draws, and writes the picture as `nacre render -o`; also layers, if `options` name a file for them. @returns
/// warnings of the scene
std::vector<std::string> save(const Structure& structure, const std::string& path, const std::string& options,
                              const Colors& colors);

/// Motion of a movie: options of `nacre movie` without dashes, and their values.
struct Moving {
    std::vector<std::pair<std::string, std::string>> motion;
    app::MovieModels models = app::MovieModels::one;
    bool loop = false;  ///< of a morph
};
/// Draws a movie. @param between  called after each frame; if it throws, nothing is written
/// @returns the number of frames, and warnings of the scene
std::pair<std::uint64_t, std::vector<std::string>> movie(const Structure& structure, const std::string& path,
                                                         const Moving& moving, const std::string& options,
                                                         const Colors& colors, const std::function<void()>& between);

/// Writes triangles, as `nacre export`. @returns warnings of the scene
std::vector<std::string> exportScene(const Structure& structure, const std::string& path, const std::string& options,
                                     const Colors& colors);

/// One value per atom. @throws app::UsageError if the selection is invalid
std::vector<bool> selected(const Structure& structure, const std::string& selection);

/// The options of `nacre render` for draw(): names with '_', and the first sentence of their help.
std::vector<std::pair<std::string, std::string>> optionNames();
/// These options as JSON Schema.
std::string schemaOfOptions();

// Shared by the sources of this folder.

/// The description to draw. @param output  determines the format; it is not created @throws app::UsageError
app::PictureDescription makeRequest(const Structure& structure, const std::string& json, const std::string& output);
constexpr const char* kPlain = "picture.png";  ///< a format that keeps a picture's pixels unchanged
/// @param good  whether the path has one of these extensions @throws app::UsageError that names `who`
void checkName(const char* who, const std::string& path, bool good, std::span<const std::string> endings);
/// Draws a structure's scene with exclusive use of the renderer. @throws Error; also in a forked process
using Draw = std::function<void(app::Drawing&, app::Canvas&)>;
void withScene(const Structure& structure, const app::PictureDescription& request, const Colors& colors,
               const Draw& draw);

}  // namespace nacre::python
