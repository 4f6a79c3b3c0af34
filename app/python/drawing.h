#pragma once
// What the Python module draws with: the options of a picture, and one renderer for all threads.

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/drawing/drawing.h"
#include "app/images/image_file.h"
#include "engine/molecule/molecule.h"
#include "engine/results.h"

namespace nacre::python {

/// A molecule and what it was opened as, which selections and messages name. Threads may share
/// it.
struct Structure {
    std::shared_ptr<const Molecule> molecule;
    std::vector<std::string> inputs;                     ///< one, or several that are drawn together
    std::vector<std::string> warnings = {}, notes = {};  ///< of how it was opened
    /// Its scene, kept from picture to picture; whoever draws it has it alone.
    struct Kept {
        std::mutex turn;
        app::Drawing drawing;
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
Drawn draw(const Structure& structure, const std::string& options);
LayerPicture drawLayers(const Structure& structure, const std::string& options, std::vector<std::string>& warnings);

/// Draws, and writes the picture as `nacre render -o` does; layers, too, if `options` name a file for them.
/// @returns warnings of the scene
std::vector<std::string> save(const Structure& structure, const std::string& path, const std::string& options);

/// The options of `nacre render` that draw() takes: names with '_', and the first sentence of their help.
std::vector<std::pair<std::string, std::string>> optionNames();

}  // namespace nacre::python
