#pragma once
// Files by descriptor: what is read is what was checked, whatever the names lead to afterwards.

#include <memory>
#include <string>

namespace nacre::app {

class OpenedFile;
class UnnamedFile;

/// A folder, as it was opened.
class OpenFolder : public std::enable_shared_from_this<OpenFolder> {
public:
    /// Links are followed. Null: it cannot be opened.
    static std::shared_ptr<const OpenFolder> at(const std::string& path);
    ~OpenFolder();
    OpenFolder(const OpenFolder&) = delete;
    OpenFolder& operator=(const OpenFolder&) = delete;

    /// A regular file of the folder, or of one below it. Links may lead from place to place within the folder.
    /// Null: there is none, or its name leads out.
    std::shared_ptr<const OpenedFile> open(const std::string& name) const;

private:
    OpenFolder(std::string path, int folder) : path_(std::move(path)), folder_(folder) {}
    std::string path_;  ///< without links
    int folder_;
};

class OpenedFile {
public:
    ~OpenedFile();
    OpenedFile(const OpenedFile&) = delete;
    OpenedFile& operator=(const OpenedFile&) = delete;

    /// A file that stands in no folder.
    static std::shared_ptr<const OpenedFile> of(std::string name, const UnnamedFile& file);

    /// For messages: where it was found.
    const std::string& name() const { return name_; }
    /// A path under which this process opens the same file anew.
    std::string path() const;
    /// A file of the same folder, as in OpenFolder::open().
    std::shared_ptr<const OpenedFile> beside(const std::string& name) const {
        return folder_ ? folder_->open(name) : nullptr;
    }
    /// Whether it stands in one.
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
