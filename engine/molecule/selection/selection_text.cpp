#include "engine/molecule/selection/selection_text.h"

#include <algorithm>

#include "engine/error.h"
#include "engine/molecule/nearest_word.h"
#include "engine/molecule/text.h"

namespace nacre {
namespace {

using enum SelectionTest;

/// The words of a test, separated by blanks: names of PyMOL, ChimeraX and VMD that have one meaning.
struct Keywords {
    SelectionTest test;
    std::string_view words;
};
constexpr Keywords kKeywords[] = {
    {all, "all *"},
    {none, "none"},
    {protein, "protein polymer.protein"},
    {nucleic, "nucleic polymer.nucleic"},
    {polymer, "polymer pol."},
    {ligand, "ligand ligands organic org. mainligand"},
    {water, "water waters solvent sol."},
    {ion, "ion ions inorganic"},
    {backbone, "backbone bb. mainchain"},
    {sidechain, "sidechain sc."},
    {hydrogen, "hydrogen hydrogens hydro h."},
    {hetatm, "hetatm het"},
    {chain, "chain c."},
    {segment, "segi segid segname segment s."},
    {entity, "entity"},
    {residueName, "resn resname r."},
    {residueNumber, "resi resid i."},
    {atomName, "name n."},
    {element, "elem element symbol e."},
    {alternate, "altloc alt"},
    {model, "model"},
    {atomNumber, "id serial"},
    {secondary, "ss helix strand sheet loop coil"},
    {sequence, "sequence seq pepseq ps."},
    {temperatureFactor, "b bfactor b-factor"},
    {occupancy, "occupancy q"},
    {around, "around"},
    {within, "within w."},
    {expand, "expand x."},
    {extend, "extend xt."},
    {byResidue, "byres byresidue br."},
    {byChain, "bychain bc."},
    {byMolecule, "bymolecule bymol bm."},
    {neighbor, "neighbor nbr."},
    {negation, "not ! ~"},
    {conjunction, "and &"},
    {disjunction, "or |"},
};

/// Calls `visit` with each word and its test until it returns true.
template <typename Visit>
void anyKeyword(const Visit& visit) {
    for (const auto& [test, words] : kKeywords)
        for (std::string_view rest = words; !rest.empty();) {
            const std::size_t end = std::min(rest.find(' '), rest.size());
            if (visit(rest.substr(0, end), test)) return;
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
}

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
           std::string_view("()+,&|!~<>=").find(text_[end]) == std::string_view::npos &&
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
    std::optional<SelectionTest> found;
    anyKeyword([&](std::string_view word, SelectionTest test) {
        if (word == token) found = test;
        return found.has_value();
    });
    return found;
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
    anyKeyword([&](std::string_view word, SelectionTest) {
        if (word.size() > 2 && word.back() != '.') words.emplace_back(word);
        return false;
    });
    return words;
}

void SelectionText::fail(const std::string& why) const {
    // Columns count visible characters, not bytes.
    std::size_t column = 1;
    for (std::size_t i = 0; i < position_ && i < text_.size(); ++i)
        if ((static_cast<unsigned char>(text_[i]) & 0xc0) != 0x80) ++column;
    throw Error("cannot read selection", "'" + printable(text_, 120) + "'",
                "column " + std::to_string(column) + ": " + why);
}

}  // namespace nacre
