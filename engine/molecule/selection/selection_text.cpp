#include "engine/molecule/selection/selection_text.h"

#include <vector>

#include "engine/error.h"
#include "engine/molecule/nearest_word.h"
#include "engine/molecule/text.h"

namespace nacre {
namespace {

using enum SelectionTest;

struct Keyword {
    std::string_view word;
    SelectionTest test;
};
constexpr Keyword kKeywords[] = {
    {"all", all},
    {"*", all},
    {"none", none},
    {"protein", protein},
    {"polymer.protein", protein},
    {"nucleic", nucleic},
    {"polymer.nucleic", nucleic},
    {"polymer", polymer},
    {"pol.", polymer},
    {"ligand", ligand},
    {"ligands", ligand},
    {"water", water},
    {"waters", water},
    {"solvent", water},
    {"sol.", water},
    {"ion", ion},
    {"ions", ion},
    {"backbone", backbone},
    {"bb.", backbone},
    {"sidechain", sidechain},
    {"sc.", sidechain},
    {"hydrogen", hydrogen},
    {"hydrogens", hydrogen},
    {"hydro", hydrogen},
    {"h.", hydrogen},
    {"hetatm", hetatm},
    {"het", hetatm},
    {"chain", chain},
    {"c.", chain},
    {"resn", residueName},
    {"resname", residueName},
    {"r.", residueName},
    {"resi", residueNumber},
    {"resid", residueNumber},
    {"i.", residueNumber},
    {"name", atomName},
    {"n.", atomName},
    {"elem", element},
    {"element", element},
    {"symbol", element},
    {"e.", element},
    {"altloc", alternate},
    {"alt", alternate},
    {"model", model},
    {"id", atomNumber},
    {"serial", atomNumber},
    {"ss", secondary},
    {"helix", secondary},
    {"strand", secondary},
    {"sheet", secondary},
    {"loop", secondary},
    {"coil", secondary},
    {"sequence", sequence},
    {"seq", sequence},
    {"pepseq", sequence},
    {"ps.", sequence},
    {"b", temperatureFactor},
    {"bfactor", temperatureFactor},
    {"b-factor", temperatureFactor},
    {"occupancy", occupancy},
    {"q", occupancy},
    {"organic", ligand},
    {"org.", ligand},
    {"inorganic", ion},
    {"mainchain", backbone},
    {"around", around},
    {"within", within},
    {"w.", within},
    {"byres", byResidue},
    {"byresidue", byResidue},
    {"br.", byResidue},
    {"not", negation},
    {"!", negation},
    {"and", conjunction},
    {"&", conjunction},
    {"or", disjunction},
    {"|", disjunction},
};

}  // namespace

void SelectionText::skipBlanks() {
    while (position_ < text_.size() && isBlank(text_[position_])) ++position_;
}

bool SelectionText::atEnd() {
    skipBlanks();
    return atEndHere();
}

std::size_t SelectionText::wordEnd() const {
    std::size_t end = position_;
    while (end < text_.size() && !isBlank(text_[end]) &&
           std::string_view("()+,&|!<>=").find(text_[end]) == std::string_view::npos &&
           !(chimera_ && kMarks.find(text_[end]) != std::string_view::npos))
        ++end;
    return end;
}

std::string_view SelectionText::word() {
    const std::size_t begin = position_;
    position_ = wordEnd();
    return text_.substr(begin, position_ - begin);
}

std::string_view SelectionText::nextToken() {
    skipBlanks();
    if (atEndHere()) return {};
    const std::size_t end = wordEnd();
    return text_.substr(position_, end > position_ ? end - position_ : 1);
}

std::optional<SelectionTest> SelectionText::keyword() {
    const std::string token = lowerCase(nextToken());
    for (const Keyword& entry : kKeywords)
        if (entry.word == token) return entry.test;
    return std::nullopt;
}

bool SelectionText::accept(SelectionTest wanted) {
    if (keyword() != wanted) return false;
    position_ += nextToken().size();
    return true;
}

bool SelectionText::acceptCharacter(char wanted) {
    if (atEnd() || text_[position_] != wanted) return false;
    ++position_;
    return true;
}

void SelectionText::expected(const std::string& wanted, const std::vector<std::string>& meant) {
    skipBlanks();
    std::string found = atEndHere() ? "the end" : "'" + printable(nextToken(), 24) + "'";
    fail("expected " + wanted + ", found " + found + suggestion(nextToken(), meant));
}

std::vector<std::string> SelectionText::keywords() {
    std::vector<std::string> words;
    for (const Keyword& entry : kKeywords)
        if (entry.word.size() > 2 && entry.word.back() != '.') words.emplace_back(entry.word);
    return words;
}

void SelectionText::fail(const std::string& why) const {
    // Columns count characters as people see them, so that bytes within one do not count.
    std::size_t column = 1;
    for (std::size_t i = 0; i < position_ && i < text_.size(); ++i)
        if ((static_cast<unsigned char>(text_[i]) & 0xc0) != 0x80) ++column;
    throw Error("cannot read selection", "'" + printable(text_, 120) + "'",
                "column " + std::to_string(column) + ": " + why);
}

}  // namespace nacre
