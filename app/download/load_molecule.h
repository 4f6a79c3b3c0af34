#pragma once

#include <functional>
#include <memory>

#include "app/download/load_scene.h"
#include "app/picture/input_options.h"
#include "engine/error.h"
#include "engine/molecule/model_file.h"
#include "engine/molecule/molecule.h"

namespace nacre::app {

/// A saved view names an input that would have to be downloaded, which is not allowed.
class DownloadForbidden : public Error {
public:
    using Error::Error;
};

/// There is no file of that name.
class InputMissing : public Error {
public:
    explicit InputMissing(const std::string& path, const std::string& hint = {})
        : Error("cannot read molecule", path, "No such file or directory" + hint), path_(path) {}
    const std::string& path() const { return path_; }

private:
    std::string path_;
};

/// Reads the molecule of INPUT, downloading it if needed. A trajectory's frame sets its atoms' positions. Further
/// inputs are read likewise and joined into one molecule (several_inputs.h). An input of a saved view is only taken
/// from the cache, unless downloads are allowed; a file outside of the view's folder is announced on standard error
/// before it is opened; and errors do not quote a file that is not a molecule.
/// @param onDownload  called as a download's bytes arrive, with the finished share, 0..1
/// @param onModel  called after each model of `--model all` with the share read, 0..1
/// @param onStep  called between the nodes of a scene; may throw to end it
/// @throws Error, DownloadForbidden, InputMissing with a suggestion
Molecule loadMolecule(const InputOptions& input, const std::function<void(double)>& onDownload = {},
                      const std::function<void(double)>& onModel = {}, const std::function<void()>& onStep = {});

/// A snapshot of an open scene. @throws Error, DownloadForbidden
Molecule loadSnapshot(OpenScene& scene, const InputOptions& input, const std::function<void(double)>& onDownload = {},
                      std::optional<double> seconds = {});

/// The models of INPUT, each read on demand. @throws Error as above, or if there is only one
std::unique_ptr<ModelFile> openModels(const InputOptions& input, const std::function<void(double)>& onDownload = {});

}  // namespace nacre::app
