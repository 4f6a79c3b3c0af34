#include "engine/molecule/read.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <new>

#include "engine/error.h"
#include "engine/molecule/formats/decompress.h"
#include "engine/molecule/formats/detect.h"
#include "engine/molecule/formats/readers.h"
#include "engine/molecule/formats/text_encoding.h"
#include "engine/molecule/read_models.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

struct NamedFormat {
    std::string_view name;
    Format format;
};
constexpr NamedFormat kFormats[] = {
    {"pdb", Format::pdb},   {"mmcif", Format::mmcif}, {"mmjson", Format::mmjson}, {"bcif", Format::bcif},
    {"mmtf", Format::mmtf}, {"sdf", Format::sdf},     {"xyz", Format::xyz},       {"mol2", Format::mol2},
    {"pqr", Format::pqr},   {"gro", Format::gro},     {"pdbqt", Format::pdbqt},   {"cml", Format::cml},
};

bool isBinary(Format format) { return format == Format::bcif || format == Format::mmtf; }

/// '\n' for every end of line, whatever the file came from; in place.
void unifyLineEnds(std::string& text) {
    std::size_t from = text.find('\r');
    if (from == std::string::npos) return;
    std::size_t to = from;
    for (; from < text.size(); ++from) {
        const bool pair = text[from] == '\r' && from + 1 < text.size() && text[from + 1] == '\n';
        if (!pair) text[to++] = text[from] == '\r' ? '\n' : text[from];
    }
    text.resize(to);
}

Error tooLarge(const std::string& name, std::size_t maxBytes) {
    return Error("cannot read molecule", name, "it is larger than the limit of " + std::to_string(maxBytes) + " bytes");
}

FileContent contentOf(const std::string& name, std::string bytes, const ReadOptions& options) {
    if (!compressionOf(bytes).empty()) bytes = decompress(name, bytes, options.maxBytes);
    if (startsWith(bytes, "\xEF\xBB\xBF")) bytes.erase(0, 3);
    if (bytes.size() > options.maxBytes) throw tooLarge(name, options.maxBytes);
    if (auto utf8 = utf8FromUtf16(bytes)) bytes = std::move(*utf8);
    if (bytes.empty()) throw Error("cannot read molecule", name, "it is empty");
    std::optional<Format> known = options.format;
    if (!known) known = detectBinaryFormat(bytes);
    if (!known || !isBinary(*known)) unifyLineEnds(bytes);
    const Format format = known ? *known : detectFormat(name, bytes);
    return {std::move(bytes), format};
}

struct CloseFile {
    void operator()(std::FILE* file) const {
        if (file != stdin) std::fclose(file);
    }
};

/// Grows by what is there, to the limit and no further: a device or a pipe may never end.
/// @param expected  bytes that are probably there; 0 if that is not known
std::string readAll(std::FILE* file, const std::string& name, std::size_t maxBytes, std::uintmax_t expected) {
    constexpr std::size_t kChunk = std::size_t{1} << 20;
    std::string bytes;
    bytes.reserve(static_cast<std::size_t>(std::min<std::uintmax_t>(expected, maxBytes)) + kChunk);
    for (;;) {
        const std::size_t size = bytes.size();
        if (size > maxBytes) throw tooLarge(name, maxBytes);
        const std::size_t chunk = std::min(kChunk, maxBytes - size + 1);
        if (size + chunk > bytes.capacity()) bytes.reserve(std::max(std::min(2 * size, maxBytes) + 1, size + chunk));
        bytes.resize(size + chunk);
        const std::size_t got = std::fread(bytes.data() + size, 1, chunk, file);
        bytes.resize(size + got);
        if (got == 0) break;
    }
    if (std::ferror(file)) throw Error("cannot read molecule", name, std::strerror(errno));
    return bytes;
}

}  // namespace

Error tooManyAtoms(const std::string& name, std::size_t maxAtoms) {
    const char* why = maxAtoms < kMaxAtoms ? ", all that there is memory for" : "";
    return {"cannot read molecule", name, "more than " + std::to_string(maxAtoms) + " atoms" + why};
}

std::optional<Format> formatFromName(std::string_view name) {
    for (const NamedFormat& known : kFormats)
        if (name == known.name) return known.format;
    return std::nullopt;
}

std::string_view formatName(Format format) {
    for (const NamedFormat& known : kFormats)
        if (format == known.format) return known.name;
    return {};
}

std::string formatNames() {
    std::string names;
    for (const NamedFormat& known : kFormats) names += (names.empty() ? "" : ", ") + std::string(known.name);
    return names;
}

Molecule readMolecule(const std::string& name, std::string bytes, const ReadOptions& options) {
    try {
        if (options.model < 0) throw Error("cannot read molecule", name, "models are numbered from 1");
        const FileContent content = contentOf(name, std::move(bytes), options);
        return options.model == kAllModels ? readAllModels(name, content, options) : readModel(name, content, options);
    } catch (const Error& error) {
        // Readers quote files and names; one line of clean text leaves here whatever they held.
        throw Error(printable(error.what(), kMaxMessage), "", "");
    } catch (const std::bad_alloc&) {
        throw Error("cannot read molecule", printable(name, kMaxMessage), "not enough memory");
    }
}

Molecule readMoleculeFile(const std::string& path, const ReadOptions& options) {
    if (path == "-")
        return readMolecule("standard input", readAll(stdin, "standard input", options.maxBytes, 0), options);
    const std::string shown = printable(path, kMaxMessage);
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) throw Error("cannot read molecule", shown, "it is a folder");
    const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
    if (!file) throw Error("cannot read molecule", shown, std::strerror(errno));
    const std::uintmax_t size = std::filesystem::file_size(path, ignored);
    return readMolecule(path, readAll(file.get(), shown, options.maxBytes, ignored ? 0 : size), options);
}

}  // namespace nacre
