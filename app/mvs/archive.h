#pragma once
// A MolViewSpec archive (.mvsx): a zip with index.mvsj and the files that it names.

#include <memory>
#include <string>
#include <string_view>

namespace nacre::app::mvs {

/// Whether the bytes begin like a zip file.
bool looksLikeArchive(std::string_view bytes);

/// Entries are limited before memory is allocated: 10,000 entries, 512 MiB each, and 100 times their compressed size
/// beyond a mebibyte. Names that lead out of the archive are refused.
class SceneArchive {
public:
    /// @param name  of the file, for messages @throws Error
    SceneArchive(std::string name, std::string bytes);
    ~SceneArchive();
    SceneArchive(const SceneArchive&) = delete;

    bool holds(const std::string& entry) const;
    /// @throws Error
    std::string read(const std::string& entry) const;

private:
    struct Zip;
    std::string name_;
    std::unique_ptr<Zip> zip_;
};

}  // namespace nacre::app::mvs
