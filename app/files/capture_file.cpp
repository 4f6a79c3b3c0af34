#include "app/files/capture_file.h"

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "engine/error.h"

namespace nacre::app {
namespace {

// RenderDoc's container, version 1.2: a header, then sections, each after its own header and name. Little-endian. If a
// section's length could not be written, the next header lies in the middle of a section.
constexpr std::size_t kFileHeader = 16, kSectionHeader = 40;
constexpr std::uint32_t kLongestName = 1024;
constexpr std::uint32_t kContainerVersion = 0x102;

template <typename T>
T numberAt(const char* bytes, std::size_t offset) {
    T number;
    std::memcpy(&number, bytes + offset, sizeof number);
    return number;
}

}  // namespace

bool isWholeCapture(const std::string& path) {
    std::error_code error;
    const std::uint64_t size = std::filesystem::file_size(path, error);
    std::ifstream stream(path, std::ios::binary);
    char head[kSectionHeader];
    if (error || !stream.read(head, kFileHeader) || std::memcmp(head, "RDOC", 4) != 0) return false;
    if (numberAt<std::uint32_t>(head, 8) != kContainerVersion) return true;  // from an unknown version of RenderDoc
    std::uint64_t at = numberAt<std::uint32_t>(head, 12);
    while (at < size) {
        if (!stream.seekg(static_cast<std::streamoff>(at)) || !stream.read(head, kSectionHeader)) return false;
        const auto bytes = numberAt<std::uint64_t>(head, 8);
        const auto nameBytes = numberAt<std::uint32_t>(head, 36);
        if (numberAt<std::uint32_t>(head, 0) != 0 || bytes > size || nameBytes > kLongestName) return false;
        std::string name(nameBytes, '\0');
        if (!stream.read(name.data(), nameBytes) || !name.starts_with("renderdoc/")) return false;
        at += kSectionHeader + nameBytes + bytes;
    }
    return at == size;
}

std::string captureStem(OutputFile& file) {
    std::string stem = file.temporary();
    stem.resize(stem.size() - fileExtension(stem).size());
    file.alsoRemove(stem + "_capture.rdc");  // RenderDoc's name for a stem
    return stem;
}

void keepCapture(const std::string& written, OutputFile& file) {
    std::error_code error;
    if (!isWholeCapture(written)) {
        std::filesystem::remove(written, error);
        throw Error("cannot write file", file.path(), "the data could not be written (is the disk full?)");
    }
    std::filesystem::rename(written, file.temporary(), error);
    if (error) throw Error("cannot write file", file.path(), error.message());
    file.commit();
}

}  // namespace nacre::app
