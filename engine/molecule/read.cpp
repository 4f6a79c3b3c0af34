#include "engine/molecule/read.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <new>

#include "engine/error.h"
#include "engine/molecule/bonds/bonds.h"
#include "engine/molecule/formats/decompress.h"
#include "engine/molecule/formats/detect.h"
#include "engine/molecule/formats/mmcif_model_texts.h"
#include "engine/molecule/formats/readers.h"
#include "engine/molecule/formats/text_encoding.h"
#include "engine/molecule/overlay_models.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

constexpr std::size_t kMaxMessage = 600;
constexpr std::size_t kMaxWarnings = 32;
constexpr std::uint64_t kMostBytesOfPasses = std::uint64_t{1} << 32;  // that --model all reads

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

/// A file's content as readers want it.
struct Content {
    std::string bytes;
    Format format;
};

Content contentOf(const std::string& name, std::string bytes, const ReadOptions& options) {
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

Molecule dispatch(const std::string& name, const Content& content, const ReadOptions& options) {
    const std::string_view bytes = content.bytes;
    switch (content.format) {
        case Format::pdb:
            return readPdb(name, bytes, options);
        case Format::mmcif:
            return readMmcif(name, bytes, options);
        case Format::mmjson:
            return readMmjson(name, bytes, options);
        case Format::bcif:
            return readBcif(name, bytes, options);
        case Format::mmtf:
            return readMmtf(name, bytes, options);
        case Format::sdf:
            return readSdf(name, bytes, options);
        case Format::xyz:
            return readXyz(name, bytes, options);
        case Format::mol2:
            return readMol2(name, bytes, options);
        case Format::pqr:
            return readPqr(name, bytes, options);
        case Format::gro:
            return readGro(name, bytes, options);
        case Format::pdbqt:
            return readPdbqt(name, bytes, options);
        case Format::cml:
            return readCml(name, bytes, options);
    }
    throw Error("cannot read molecule", name, "no reader for its format");
}

/// One model with all its bonds.
Molecule readModel(const std::string& name, const Content& content, const ReadOptions& options) {
    Molecule molecule = dispatch(name, content, options);
    if (molecule.warnings.size() > kMaxWarnings) molecule.warnings.resize(kMaxWarnings);
    for (std::string& warning : molecule.warnings) warning = printable(warning, kMaxMessage);
    molecule.file.title = printable(molecule.file.title, kMaxMessage);
    for (Chain& chain : molecule.chains) chain.model = options.model;
    perceiveBonds(molecule);
    return molecule;
}

/// The texts of the models of an mmCIF file, if there are as many as the reader found. Most readers step over models
/// fast; the grammar of CIF does not.
MmcifModelTexts textsOfModels(const Content& content, std::int64_t models) {
    if (content.format != Format::mmcif || models < 2) return {};
    MmcifModelTexts texts = mmcifModelTexts(content.bytes);
    if (texts.models.size() != static_cast<std::size_t>(models)) texts.models.clear();
    return texts;
}

/// The model of `options.model` from its own text. Nothing if that is otherwise than the cut has it, or if something is
/// to be said of it, since the whole text knows the line.
std::optional<Molecule> readCutModel(const std::string& name, const MmcifModelTexts& texts,
                                     const ReadOptions& options) {
    const std::string_view rows = texts.models[static_cast<std::size_t>(options.model - 1)];
    ReadOptions first = options;
    first.model = 1;
    try {
        const Content alone{std::string(texts.before).append(rows).append(texts.after), Format::mmcif};
        Molecule molecule = readModel(name, alone, first);
        if (molecule.file.models != 1 || !molecule.warnings.empty()) return std::nullopt;
        for (Chain& chain : molecule.chains) chain.model = options.model;
        return molecule;
    } catch (const Error&) {
        return std::nullopt;
    }
}

void boundPasses(const std::string& name, std::int64_t passes, std::size_t bytes) {
    if (static_cast<std::uint64_t>(passes) > kMostBytesOfPasses / std::max<std::size_t>(bytes, 1))
        throw Error("cannot read molecule", name,
                    "it has too many models for --model all: " + std::to_string(passes) + " times " +
                        std::to_string(bytes) + " bytes are more than " + std::to_string(kMostBytesOfPasses));
}

/// Each reader reads one model and steps over the others, so that all of them take as many passes, unless the text of
/// each can be cut out.
Molecule readAllModels(const std::string& name, const Content& content, ReadOptions options) {
    options.model = 1;
    std::vector<Molecule> models;
    models.push_back(readModel(name, content, options));
    const FileSummary& file = models.front().file;
    const std::int64_t count = std::max(file.models.value_or(1), file.records.value_or(1));
    const MmcifModelTexts texts = textsOfModels(content, count);
    bool cut = !texts.models.empty();
    boundPasses(name, count, cut ? texts.before.size() + texts.after.size() : content.bytes.size());
    const std::size_t maxAtoms = options.maxAtoms;
    const auto tell = [&] {
        if (options.onModel) options.onModel(static_cast<double>(models.size()) / static_cast<double>(count));
    };
    tell();
    for (options.model = 2; options.model <= count; ++options.model) {
        if (models.back().atoms.size() > options.maxAtoms) throw tooManyAtoms(name + ", all models", maxAtoms);
        options.maxAtoms -= models.back().atoms.size();
        if (cut) {
            if (std::optional<Molecule> model = readCutModel(name, texts, options)) {
                models.push_back(std::move(*model));
                tell();
                continue;
            }
            cut = false;  // a second time in vain would be twice the work
            boundPasses(name, count, content.bytes.size());
        }
        models.push_back(readModel(name, content, options));
        tell();
    }
    return overlayModels(name, std::move(models), maxAtoms);
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
        if (size + chunk > bytes.capacity()) bytes.reserve(std::max(std::min(2 * size, maxBytes + 1), size + chunk));
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
        const Content content = contentOf(name, std::move(bytes), options);
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
