#pragma once
// Files by descriptor: the file that is read is the one that was checked, wherever its name leads later.

#include <memory>
#include <string>

namespace nacre::app {

class OpenedFile;
class UnnamedFile;

/// An open folder.
class OpenFolder : public std::enable_shared_from_this<OpenFolder> {
public:
    /// Follows links. Null if it cannot be opened.
    static std::shared_ptr<const OpenFolder> at(const std::string& path);
    ~OpenFolder();
    OpenFolder(const OpenFolder&) = delete;
    OpenFolder& operator=(const OpenFolder&) = delete;

    /// A regular file in the folder or below it. Links may lead elsewhere within the folder. Null if there is none, or
    /// its name leads out.
    std::shared_ptr<const OpenedFile> open(const std::string& name) const;

private:
    OpenFolder(std::string path, int folder) : path_(std::move(path)), folder_(folder) {}
    std::string path_;  ///< with links resolved
    int folder_;
};

class OpenedFile {
public:
    ~OpenedFile();
    OpenedFile(const OpenedFile&) = delete;
    OpenedFile& operator=(const OpenedFile&) = delete;

    /// A file without a folder.
    static std::shared_ptr<const OpenedFile> of(std::string name, const UnnamedFile& file);

    /// The path where it was found, for messages.
    const std::string& name() const { return name_; }
    /// A path under which this process can open the same file again.
    std::string path() const;
    /// Another file in its folder, as in OpenFolder::open().
    std::shared_ptr<const OpenedFile> beside(const std::string& name) const {
        return folder_ ? folder_->open(name) : nullptr;
    }
    /// Whether it has a folder.
    bool hasFolder() const { return folder_ != nullptr; }

private:
    friend class OpenFolder;
    OpenedFile(std::string name, int file, std::shared_ptr<const OpenFolder> folder)
        : name_(std::move(name)), file_(file), folder_(std::move(folder)) {}
    std::string name_;
    int file_;
    std::shared_ptr<const OpenFolder> folder_;
};

}  // namespace nacre::app
