#include "engine/molecule/formats/pdb_header.h"

#include <functional>

#include "engine/molecule/formats/pdb_fields.h"
#include "engine/molecule/formats/plain_names.h"
#include "engine/molecule/text.h"

namespace nacre::pdb {
namespace {

/// Joins lines; a word broken at a hyphen continues without a blank.
void join(std::string& text, std::string_view part, std::size_t most) {
    if (part.empty() || text.size() + part.size() > most) return;
    if (!text.empty() && text.back() != '-') text += ' ';
    text += part;
}

/// Calls `visit` for each "KEY: value" of "MOL_ID: 1; MOLECULE: HIV-1 PROTEASE; CHAIN: A, B;".
void eachToken(std::string_view text, const std::function<void(std::string_view key, std::string_view value)>& call) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(';'), text.size());
        const std::string_view token = text.substr(0, end);
        if (const std::size_t colon = token.find(':'); colon != std::string_view::npos)
            call(nacre::trim(token.substr(0, colon)), nacre::trim(token.substr(colon + 1)));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

}  // namespace

void Header::add(std::string_view line, std::uint64_t number) {
    if (startsWith(line, "HEADER")) {
        entry_ = nacre::trim(columns(line, 63, 66));
        return;
    }
    // Old files number their lines at the right: "1HPV   3".
    const bool numbered = !entry_.empty() && nacre::trim(columns(line, 73, 76)) == entry_;
    const std::size_t last = numbered ? 72 : 80;
    if (startsWith(line, "CRYST1")) {
        takeCrystal(line, number);
    } else if (startsWith(line, "COMPND")) {
        join(compound_, nacre::trim(columns(line, 11, last)), kMostText);
    } else if (startsWith(line, "SOURCE")) {
        join(source_, nacre::trim(columns(line, 11, last)), kMostText);
    } else if (startsWith(line, "EXPDTA")) {
        join(method_, nacre::trim(columns(line, 11, last)), kMostText);
    } else if (startsWith(line, "HETNAM") || startsWith(line, "HETSYN")) {
        auto& texts = startsWith(line, "HETNAM") ? names_ : synonyms_;
        const std::string name(nacre::trim(columns(line, 12, 14)));
        if (texts.size() < kMostNames || texts.contains(name))
            join(texts[name], nacre::trim(columns(line, 16, last)), kLongestName * 10);
    }
}

void Header::takeCrystal(std::string_view line, std::uint64_t number) {
    static constexpr std::array<std::pair<std::size_t, std::size_t>, 6> kColumns{
        {{7, 15}, {16, 24}, {25, 33}, {34, 40}, {41, 47}, {48, 54}}};
    std::array<double, 6> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto value = parseNumber(columns(line, kColumns[i].first, kColumns[i].second));
        if (value && *value == 0) return;  // there is none
        if (!value || !(*value > 0 && *value < (i < 3 ? 1e6 : 180))) {
            unusableCell_ = number;
            return;
        }
        values[i] = *value;
    }
    // Files without a crystal state 1 1 1 90 90 90.
    if (values[0] <= 1 && values[1] <= 1 && values[2] <= 1) return;
    cell_ = values;
    spaceGroup_ = nacre::trim(columns(line, 56, 66));
}

void Header::resolve(Molecule& molecule) const {
    FileSummary& file = molecule.file;
    if (unusableCell_ > 0)
        addNote(molecule.notes, ReadAction::leftOut, "unit cells", "no usable lengths and angles", 1, unusableCell_);
    file.cell = cell_;
    file.spaceGroup = spaceGroup_;
    std::string called;
    eachToken(compound_, [&](std::string_view key, std::string_view value) {
        if (key == "MOLECULE") called = plainCase(value, true);
        if (key != "CHAIN") return;
        while (!value.empty()) {
            const std::size_t end = std::min(value.find(','), value.size());
            noteName(file.chainNames, nacre::trim(value.substr(0, end)), called);
            value.remove_prefix(std::min(end + 1, value.size()));
        }
    });
    eachToken(source_, [&](std::string_view key, std::string_view value) {
        if (key == "ORGANISM_SCIENTIFIC") addToList(file.organism, plainCase(value, true));
    });
    addToList(file.method, plainCase(method_, true));
    for (const auto& [name, text] : names_) {
        const auto synonyms = synonyms_.find(name);
        noteName(file.componentNames, name,
                 plainComponentName(text, synonyms == synonyms_.end() ? "" : synonyms->second));
    }
    if (file.title.empty() && compound_.find(':') == std::string::npos) file.title = printable(compound_, kLongestName);
}

}  // namespace nacre::pdb
