#pragma once

#include <functional>
#include <memory>

#include "app/picture/input_options.h"
#include "engine/error.h"
#include "engine/molecule/model_file.h"
#include "engine/molecule/molecule.h"

namespace nacre::app {

/// What a saved view names would have to be downloaded, and that is not allowed.
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

/// Reads the molecule that INPUT names, downloading it if need be.
/// Its atoms stand where the frame of its trajectory, if it has one, puts them.
/// Further inputs are read like it, and all are one molecule then (several_inputs.h).
/// One that a saved view names is not downloaded unless that is allowed, only taken from the cache; a file outside of
/// the view's folder is told on standard error before it is opened; and why a file does not read as a molecule is not
/// said, since that would quote it.
/// @param onDownload  called as a download's bytes arrive, with the share that is there, 0..1
/// @param onModel  called after each model of `--model all` with the share that is read, 0..1
/// @throws Error, DownloadForbidden, InputMissing with what was probably meant
Molecule loadMolecule(const InputOptions& input, const std::function<void(double)>& onDownload = {},
                      const std::function<void(double)>& onModel = {});

/// The models of INPUT, each to be read as it is needed. @throws Error as above, or if it has one alone
std::unique_ptr<ModelFile> openModels(const InputOptions& input, const std::function<void(double)>& onDownload = {});

}  // namespace nacre::app
