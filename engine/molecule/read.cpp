#include "engine/molecule/read.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <new>

#include "engine/error.h"
#include "engine/molecule/formats/content.h"
#include "engine/molecule/formats/read_models.h"
#include "engine/molecule/formats/readers.h"
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

struct CloseFile {
    void operator()(std::FILE* file) const {
        if (file != stdin) std::fclose(file);
    }
};

/// Readers quote files and names; one line of clean text leaves here whatever they held.
template <typename Read>
auto cleanly(const std::string& name, Read&& read) {
    try {
        return read();
    } catch (const Error& error) {
        throw Error(printable(error.what(), kMaxMessage), "", "");
    } catch (const std::bad_alloc&) {
        throw Error("cannot read molecule", printable(name, kMaxMessage), "not enough memory");
    }
}

/// A model of a long text, whose other models are not held. @param inflated  as of textContentOf()
std::optional<Molecule> readAlone(const std::string& path, const ReadOptions& options, std::string& inflated) {
    return cleanly(path, [&]() -> std::optional<Molecule> {
        std::optional<TextContent> content = textContentOf(path, options, inflated);
        return content ? readModelAlone(path, std::move(*content), options) : std::nullopt;
    });
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
    return cleanly(name, [&] {
        if (options.model < 0) throw Error("cannot read molecule", name, "models are numbered from 1");
        const FileContent content = contentOf(name, std::move(bytes), options);
        return options.model == kAllModels ? readAllModels(name, content, options) : readModel(name, content, options);
    });
}

Molecule readMoleculeFile(const std::string& path, const ReadOptions& options) {
    if (path == "-")
        return readMolecule("standard input", readAll(stdin, "standard input", options.maxBytes, 0), options);
    const std::string shown = printable(path, kMaxMessage);
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) throw Error("cannot read molecule", shown, "it is a folder");
    const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
    if (!file) throw Error("cannot read molecule", shown, std::strerror(errno));
    std::string inflated;
    if (options.model != kAllModels)
        if (std::optional<Molecule> alone = readAlone(path, options, inflated)) return std::move(*alone);
    if (!inflated.empty()) return readMolecule(path, std::move(inflated), options);
    const std::uintmax_t size = std::filesystem::file_size(path, ignored);
    return readMolecule(path, readAll(file.get(), shown, options.maxBytes, ignored ? 0 : size), options);
}

}  // namespace nacre
