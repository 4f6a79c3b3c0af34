#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/molecule/read.h"
#include "engine/molecule/selection/selection.h"

namespace nacre::app {

class OpenedFile;

/// Positions from a separate file.
struct TrajectoryOptions {
    std::string path;              ///< empty: none
    std::string namedBy;           ///< file of the saved view that names it; empty: the user does
    std::string hash;              ///< of its content, from that view; see trajectoryHash()
    std::int64_t frame = 1;        ///< counted from 1
    bool whole = false;            ///< make molecules whole that the periodic box cuts
    std::optional<Selection> fit;  ///< atoms that fit frames to the first; empty: no fit
    std::int64_t smooth = 1;       ///< number of frames averaged, odd
};

/// Another molecule in the same picture.
struct FurtherInput {
    std::string name;                               ///< for selections; empty: derived from its path
    std::string path;                               ///< as in InputOptions
    std::string hash;                               ///< as in InputOptions
    std::shared_ptr<const OpenedFile> opened = {};  ///< as in InputOptions
    friend bool operator==(const FurtherInput&, const FurtherInput&) = default;
};

constexpr int kAllSnapshots = 0;

/// A replacement for addresses in scenes: an address or a prefix of addresses, and a file or folder.
struct SceneMap {
    std::string url, path;
    friend bool operator==(const SceneMap&, const SceneMap&) = default;
};

/// Superposes an INPUT, by some of its atoms, on atoms of another one.
struct FitOptions {
    Selection moving, fixed;
    friend bool operator==(const FitOptions&, const FitOptions&) = default;
};

/// A molecule's source, and how it is read.
struct InputOptions {
    std::string path;  ///< a file, "-", "sample:NAME", or "pdb:", "pubchem:", "afdb:" and an identifier
    std::optional<Format> format;
    int model = 1;                     ///< 1-based, or kAllModels
    bool addHydrogens = false;         ///< add hydrogens that the file lacks
    bool alone = false;                ///< without the positions of the file's other models
    bool describedOnly = false;        ///< not drawn: a topology may lack positions
    std::optional<std::string> cache;  ///< folder, or "off"; empty: the default (cache_folder.h)
    bool offline = false;              ///< downloads only from the cache
    std::string namedBy;         ///< a saved view's file that names `path`; empty: the user does. See load_molecule.h
    std::string hash;            ///< of its content, stated by that view; empty: not stated. See fileHash()
    bool allowDownload = false;  ///< inputs named by a view may be downloaded
    int snapshot = 1;            ///< of a scene, counted from 1, or kAllSnapshots
    std::vector<SceneMap> sceneMaps;  ///< for scenes
    /// For untrusted scenes: hosts from which they may download, in addition to the databases. Empty: any.
    std::optional<std::vector<std::string>> sceneHosts;
    bool sceneFiles = true;                    ///< a scene may name files in its folder
    std::shared_ptr<const OpenedFile> opened;  ///< read instead of the file `path`; null: the file of that name
    TrajectoryOptions trajectory;
    std::string name;                             ///< for selections, with further inputs; empty: derived from its path
    std::vector<FurtherInput> further;            ///< read in the same way
    bool conformations = false;                   ///< they are superposed as other models of this one
    std::vector<FitOptions> fits, alignments;     ///< by sequence, and by structure, each in order
    std::optional<std::int64_t> memoryMegabytes;  ///< for the molecule, of 2^20 bytes; empty: half of the machine's

    /// Whether the picture has several molecules.
    bool several() const { return !further.empty() && !conformations; }
};

/// Reading options of a further input: like the first, with its own file.
inline InputOptions furtherInput(InputOptions first, const FurtherInput& further) {
    first.path = further.path;
    first.hash = further.hash;
    first.opened = further.opened;
    return first;
}

}  // namespace nacre::app
