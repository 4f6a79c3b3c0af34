#pragma once
// What the Python module draws with: the options of a picture, and one renderer for all threads.

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/drawing/drawing.h"
#include "app/images/image_file.h"
#include "app/python/colors.h"
#include "engine/molecule/molecule.h"
#include "engine/results.h"

namespace nacre::python {

/// A molecule and what it was opened as, which selections and messages name. Threads may share
/// it.
struct Structure {
    std::shared_ptr<const Molecule> molecule;
    std::vector<std::string> inputs;                     ///< one, or several that are drawn together
    std::vector<std::string> warnings = {}, notes = {};  ///< of how it was opened
    app::InputOptions reading = {};                      ///< how it was read: model, trajectory
    /// Its scene, kept from picture to picture; whoever draws it has it alone.
    struct Kept {
        std::mutex turn;
        app::Drawing drawing;
        Colors colors;  ///< that the drawing's scene has
    };
    std::shared_ptr<Kept> kept = std::make_shared<Kept>();
};

struct Drawn {
    Picture picture;
    app::PictureFormat format;          ///< that its options ask a file to have
    std::vector<std::string> warnings;  ///< of the scene
};

/// Files, samples or downloads, as `nacre render INPUT...`. @param options  JSON: format, model, fit and their like
/// @throws app::UsageError, Error
Structure openInputs(const std::vector<std::string>& inputs, const std::string& options);
/// A file's bytes. @param name  for messages, and a hint to the format
Structure openBytes(const std::string& name, std::string bytes, const std::string& options);

/// Draws by the one renderer, after whoever draws just now. @param options  JSON, keys as those of `nacre render`
/// @throws app::UsageError, Error
Drawn draw(const Structure& structure, const std::string& options, const Colors& colors);
LayerPicture drawLayers(const Structure& structure, const std::string& options, const Colors& colors,
                        std::vector<std::string>& warnings);

/// Draws, and writes the picture as `nacre render -o` does; layers, too, if `options` name a file for them.
/// @returns warnings of the scene
std::vector<std::string> save(const Structure& structure, const std::string& path, const std::string& options,
                              const Colors& colors);

/// What moves in a movie: options of `nacre movie` without their dashes, and their values.
struct Moving {
    std::vector<std::pair<std::string, std::string>> motion;
    bool models = false;  ///< through the models, or the trajectory that the structure was opened with
};
/// Draws a movie. @param between  called after each frame, where it may throw to end it; nothing is written then
/// @returns the number of frames, and warnings of the scene
std::pair<std::uint64_t, std::vector<std::string>> movie(const Structure& structure, const std::string& path,
                                                         const Moving& moving, const std::string& options,
                                                         const Colors& colors, const std::function<void()>& between);

/// Writes triangles, as `nacre export`. @returns warnings of the scene
std::vector<std::string> exportScene(const Structure& structure, const std::string& path, const std::string& options,
                                     const Colors& colors);

/// One value per atom. @throws app::UsageError if it is no selection
std::vector<bool> selected(const Structure& structure, const std::string& selection);

/// The options of `nacre render` that draw() takes: names with '_', and the first sentence of their help.
std::vector<std::pair<std::string, std::string>> optionNames();

// What the sources here share.

/// What is to be drawn. @param output  whose name tells the format; it is not made @throws app::UsageError
app::PictureDescription requestOf(const Structure& structure, const std::string& json, const std::string& output);
constexpr const char* kPlain = "picture.png";  ///< what shows a picture's pixels as they are
/// @param good  whether the path ends in one of these @throws app::UsageError that names who takes it
void checkName(const char* who, const std::string& path, bool good, std::span<const std::string> endings);
/// Draws with a structure's scene, alone at the renderer. @throws Error; also in a process that was forked
using Draw = std::function<void(app::Drawing&, app::Canvas&)>;
void withScene(const Structure& structure, const app::PictureDescription& request, const Colors& colors,
               const Draw& draw);

}  // namespace nacre::python
