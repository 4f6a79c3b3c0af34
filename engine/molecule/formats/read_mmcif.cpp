// gemmi's CIF grammar with our own actions: gemmi's document would keep every value as a string, over a gigabyte for a
// capsid of a million atoms.
#include <algorithm>
#include <gemmi/cif.hpp>
#include <iterator>

#include "engine/molecule/formats/cif_fault.h"
#include "engine/molecule/formats/mmcif_model.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

namespace pegtl = tao::pegtl;
namespace rules = gemmi::cif::rules;

constexpr std::size_t kMaxTags = 1000;  // the largest category of the dictionary has some 120

/// The meaning of a value: unquoted, '?' and '.' null.
MmcifCell meaning(std::string_view raw) {
    if (raw == "?" || raw == ".") return {};
    const char first = raw.empty() ? '\0' : raw.front();
    if ((first == '\'' || first == '"') && raw.size() >= 2 && raw.back() == first) return raw.substr(1, raw.size() - 2);
    if (first == ';' && raw.size() >= 3 && raw.substr(raw.size() - 2) == "\n;") return raw.substr(1, raw.size() - 3);
    return raw;
}

/// Follows the parse, and passes rows to the model.
class Walker {
public:
    Walker(const std::string& name, MmcifModel& model) : name_(name), model_(model) {}

    void block() {
        flushItems();
        inFrame_ = false;
        model_.beginBlock();
    }
    void frame(bool begins) {
        flushItems();
        inFrame_ = begins;
    }

    void itemTag(std::string_view tag, std::uint64_t line) {
        const auto [category, column] = split(tag);
        if (category != itemCategory_) flushItems();
        if (itemColumns_.size() >= kMaxTags) fail("too many tags in a category", line);
        itemCategory_ = category;
        itemColumns_.push_back(column);
        items_.resize(itemColumns_.size());
        if (itemColumns_.size() == 1) itemLine_ = line;
    }
    void itemValue(std::string_view raw) { items_.back() = meaning(raw); }

    void beginLoop() {
        flushItems();
        category_.clear();
        columns_.clear();
        row_.clear();
        filled_ = 0;
        open_ = false;
    }
    void loopTag(std::string_view tag, std::uint64_t line) {
        const auto [category, column] = split(tag);
        if (columns_.size() >= kMaxTags) fail("too many tags in a loop", line);
        if (columns_.empty()) category_ = category;
        columns_.push_back(column);
    }
    void loopValue(std::string_view raw, std::uint64_t line) {
        if (!open_) {
            open_ = true;
            wanted_ = !inFrame_ && model_.beginCategory(category_, columns_, line);
        }
        if (wanted_) row_.push_back(meaning(raw));
        lastLine_ = line;
        if (++filled_ < columns_.size()) return;
        if (wanted_) model_.addRow(row_, line);
        row_.clear();
        filled_ = 0;
    }
    void endLoop() {
        if (filled_ != 0)
            fail("the last row of _" + printable(category_) + " has " + std::to_string(filled_) +
                     " values instead of " + std::to_string(columns_.size()),
                 lastLine_);
    }

    void textDelimiter(std::uint64_t line) { textBegin_ = textBegin_ > 0 ? 0 : line; }
    std::uint64_t textBegin() const { return textBegin_; }  ///< line of a text field that is still open, or 0

    void flushItems() {
        if (!itemColumns_.empty() && !inFrame_ && model_.beginCategory(itemCategory_, itemColumns_, itemLine_))
            model_.addRow(items_, itemLine_);
        itemColumns_.clear();
        items_.clear();
        itemCategory_.clear();
    }

private:
    [[noreturn]] void fail(const std::string& why, std::uint64_t line) const { cannotRead(name_, why, line); }
    static std::pair<std::string, std::string> split(std::string_view tag) {
        const std::string lower = lowerCase(tag.substr(1));
        const std::size_t dot = lower.find('.');
        if (dot == std::string::npos) return splitCore(lower);
        return {lower.substr(0, dot), lower.substr(dot + 1)};
    }

    /// Tags of small-molecule CIF have no dot: _atom_site_fract_x is mmCIF's _atom_site.fract_x.
    static std::pair<std::string, std::string> splitCore(const std::string& tag) {
        // Longer names first.
        static constexpr std::string_view kCategories[] = {"atom_site_aniso",   "atom_site",  "cell",
                                                           "symmetry_equiv",    "symmetry",   "chemical",
                                                           "space_group_symop", "space_group"};
        for (const std::string_view category : kCategories)
            if (startsWith(tag, category) && tag.size() > category.size() && tag[category.size()] == '_')
                return {std::string(category), tag.substr(category.size() + 1)};
        return {tag, ""};
    }

    const std::string& name_;
    MmcifModel& model_;
    bool inFrame_ = false;
    std::string itemCategory_, category_;
    std::vector<std::string> itemColumns_, columns_;
    std::vector<MmcifCell> items_, row_;
    std::uint64_t itemLine_ = 0, lastLine_ = 0, textBegin_ = 0;
    std::size_t filled_ = 0;
    bool open_ = false, wanted_ = false;
};

/// The text that a rule matched: PEGTL 2.8 has no string_view().
template <typename Input>
std::string_view toText(const Input& in) {
    return {in.begin(), in.size()};
}

template <typename Rule>
struct Action : pegtl::nothing<Rule> {};

#define NACRE_CIF_ACTION(rule, call)                     \
    template <>                                          \
    struct Action<rules::rule> {                         \
        template <typename Input>                        \
        static void apply(const Input& in, Walker& to) { \
            (void)in;                                    \
            to.call;                                     \
        }                                                \
    };
NACRE_CIF_ACTION(datablockheading, block())
NACRE_CIF_ACTION(framename, frame(true))
NACRE_CIF_ACTION(endframe, frame(false))
NACRE_CIF_ACTION(item_tag, itemTag(toText(in), in.iterator().line))
NACRE_CIF_ACTION(item_value, itemValue(toText(in)))
NACRE_CIF_ACTION(str_loop, beginLoop())
NACRE_CIF_ACTION(loop_tag, loopTag(toText(in), in.iterator().line))
NACRE_CIF_ACTION(loop_value, loopValue(toText(in), in.iterator().line))
NACRE_CIF_ACTION(loop, endLoop())
NACRE_CIF_ACTION(field_sep, textDelimiter(in.iterator().line))
#undef NACRE_CIF_ACTION

/// A data block of a file.
struct CifBlock {
    enum class Content : std::uint8_t { other, component, structure };
    std::string_view name, text;
    std::uint64_t line = 1;
    Content content = Content::other;
};

/// The blocks with atoms: structures, or else chemical components.
std::vector<CifBlock> splitBlocks(std::string_view text) {
    std::vector<CifBlock> blocks{{{}, text}};
    bool quoted = false;
    for (LineReader lines(text); lines.next();) {
        const std::string_view line = lines.line();
        if (line.empty()) continue;
        quoted = quoted != (line[0] == ';');
        if (quoted || (line[0] != '_' && line[0] != 'd' && line[0] != 'D')) continue;
        CifBlock& block = blocks.back();
        const std::string start = lowerCase(line.substr(0, 20));
        if (startsWith(start, "data_")) {
            const auto at = static_cast<std::size_t>(line.data() - block.text.data());
            const std::string_view rest = block.text.substr(at);
            block.text = block.text.substr(0, at);
            blocks.push_back({trim(line.substr(5)), rest, lines.number()});
        } else if (startsWith(start, "_atom_site.") || startsWith(start, "_atom_site_fract_") ||
                   startsWith(start, "_ihm_sphere_obj") || startsWith(start, "_ihm_gaussian_obj")) {
            block.content = CifBlock::Content::structure;
        } else if (startsWith(start, "_chem_comp_atom.")) {
            block.content = std::max(block.content, CifBlock::Content::component);
        }
    }
    CifBlock::Content best = CifBlock::Content::component;
    for (const CifBlock& block : blocks) best = std::max(best, block.content);
    blocks.erase(std::remove_if(blocks.begin(), blocks.end(), [&](const CifBlock& b) { return b.content != best; }),
                 blocks.end());
    return blocks;
}

/// @throws pegtl::parse_error if the text is not CIF
std::vector<Molecule> parseCif(const std::string& name, const CifBlock& block, const ReadOptions& options,
                               int lastModel) {
    MmcifModel model(name, block.text, options, lastModel);
    Walker walker(name, model);
    const std::string_view text = block.text;
    pegtl::memory_input<> input(text.data(), text.data() + text.size(), "", 0, static_cast<std::size_t>(block.line), 1);
    try {
        pegtl::parse<rules::file, Action, gemmi::cif::Errors>(input, walker);
    } catch (const pegtl::parse_error&) {
        if (walker.textBegin() == 0) throw;
        cannotRead(name, "this text field is never closed", walker.textBegin());
    }
    walker.flushItems();
    return model.finish("mmcif");
}

constexpr std::size_t kMostBlocksNamed = 5;

std::string describeBlocks(const std::vector<CifBlock>& blocks) {
    std::string names;
    for (std::size_t i = 0; i < blocks.size() && i < kMostBlocksNamed; ++i)
        names += (i > 0 ? ", " : "") + printable(blocks[i].name);
    return "it has " + std::to_string(blocks.size()) + " data blocks with atoms, which are read as models: " + names +
           (blocks.size() > kMostBlocksNamed ? ", ..." : "");
}

/// Blocks one after the other, as models. Unreadable ones are left out.
std::vector<Molecule> parseBlocks(const std::string& name, const std::vector<CifBlock>& blocks,
                                  const ReadOptions& options, int lastModel) {
    std::vector<Molecule> models;
    std::optional<Error> fault;
    int before = 0;  // models of the blocks before
    std::int64_t atoms = 0;
    for (const CifBlock& block : blocks) {
        ReadOptions own = options;
        own.model = 1;
        std::vector<Molecule> part;
        try {
            part = parseCif(name, block, own, 1);
        } catch (const Error& error) {
            fault = error;
            continue;
        }
        const FileSummary& file = part.front().file;
        const int count = static_cast<int>(file.models.value_or(1));
        atoms += file.totalAtomsAllModels.value_or(static_cast<std::int64_t>(part.front().atoms.size()));
        const int first = std::max(options.model - before, 1), last = std::min(lastModel - before, count);
        if (first <= last && (first > 1 || last > 1)) {
            own.model = first;
            part = parseCif(name, block, own, last);
        }
        if (first <= last) std::move(part.begin(), part.end(), std::back_inserter(models));
        before += count;
    }
    if (before == 0 && fault) throw *fault;
    if (models.empty())
        cannotRead(name,
                   "there is no model " + std::to_string(options.model) + "; the file has " + std::to_string(before));
    for (Molecule& model : models) {
        model.file.models = before;
        model.file.totalAtomsAllModels = atoms;
        model.warnings.push_back(describeBlocks(blocks));
        if (fault) model.warnings.push_back(std::string("a data block is left out: ") + fault->what());
    }
    return models;
}

std::vector<Molecule> parseFile(const std::string& name, std::string_view text, const ReadOptions& options,
                                int lastModel) {
    const std::vector<CifBlock> blocks = splitBlocks(text);
    return blocks.size() > 1 ? parseBlocks(name, blocks, options, lastModel)
                             : parseCif(name, {{}, text}, options, lastModel);
}

}  // namespace

std::vector<Molecule> readMmcif(const std::string& name, std::string_view text, const ReadOptions& options,
                                int lastModel) {
    try {
        return parseFile(name, text, options, lastModel);
    } catch (const pegtl::parse_error&) {
    }
    // Words of old files may contain letters in some other encoding, or zeros; the grammar accepts them only in quotes.
    std::string replaced(text);
    std::size_t foreign = 0;
    for (char& c : replaced) {
        const auto byte = static_cast<unsigned char>(c);
        if ((byte >= ' ' && byte < 0x7f) || c == '\n' || c == '\t') continue;
        c = '?';
        ++foreign;
    }
    try {
        std::vector<Molecule> models = parseFile(name, replaced, options, lastModel);
        models.front().warnings.push_back("bytes that CIF does not allow, read as '?': " + std::to_string(foreign));
        return models;
    } catch (const pegtl::parse_error& fault) {
        const std::string message = faultMessage(fault);
        std::string why = "not valid CIF: " + printable(message, 200);
        if (message == "parse error") why += "; perhaps a quote or a text field before it is unclosed";
        cannotRead(name, why, lineNumber(fault));
    }
}

}  // namespace nacre
