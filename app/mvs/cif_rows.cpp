#include "app/mvs/cif_rows.h"

#include <algorithm>
#include <array>

#include "engine/error.h"
#include "engine/molecule/formats/bcif_column.h"
#include "engine/molecule/text.h"

namespace nacre::app::mvs {
namespace {

[[noreturn]] void cannot(const std::string& name, const std::string& why) {
    throw Error("cannot read annotations", name, why);
}

/// Tokens of CIF 1.1: words, quoted texts, and texts between semicolons at the start of a line; skips comments.
class CifTokens {
public:
    explicit CifTokens(std::string_view text) : text_(text) {}

    enum class Kind { end, word, quoted };
    Kind next(std::string_view& token) {
        skipBlanks();
        if (at_ >= text_.size()) return Kind::end;
        const char c = text_[at_];
        if (c == ';' && (at_ == 0 || text_[at_ - 1] == '\n')) return field(token);
        if (c == '\'' || c == '"') return quoted(c, token);
        const std::size_t start = at_;
        while (at_ < text_.size() && !isBlank(text_[at_])) ++at_;
        token = text_.substr(start, at_ - start);
        return Kind::word;
    }

private:
    void skipBlanks() {
        while (at_ < text_.size()) {
            if (isBlank(text_[at_]))
                ++at_;
            else if (text_[at_] == '#')
                at_ = std::min(text_.find('\n', at_), text_.size());
            else
                return;
        }
    }
    Kind field(std::string_view& token) {
        const std::size_t start = at_ + 1;
        const std::size_t end = std::min(text_.find("\n;", at_), text_.size());
        token = text_.substr(start, end - start);
        at_ = std::min(end + 2, text_.size());
        return Kind::quoted;
    }
    /// A quote ends a text only if a blank follows it.
    Kind quoted(char quote, std::string_view& token) {
        const std::size_t start = ++at_;
        while (at_ < text_.size() && text_[at_] != '\n') {
            if (text_[at_] == quote && (at_ + 1 == text_.size() || isBlank(text_[at_ + 1]))) break;
            ++at_;
        }
        token = text_.substr(start, at_ - start);
        at_ = std::min(at_ + 1, text_.size());
        return Kind::quoted;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

/// Walks through a text's blocks, and keeps the requested table.
class CifReader {
public:
    CifReader(const std::string& name, std::string_view text, const TablePlace& place,
              const std::vector<std::string_view>& wanted)
        : name_(name), tokens_(text), place_(place), category_(lowerCase(place.category)) {
        if (category_.starts_with("_")) category_.erase(0, 1);
        for (const std::string_view column : wanted) wanted_.emplace_back(column);
    }

    AnnotationTable read() {
        step();
        while (kind_ != CifTokens::Kind::end && !done_) {
            const std::string word = kind_ == CifTokens::Kind::word ? lowerCase(token_) : std::string();
            if (word.starts_with("data_"))
                beginBlock(std::string(token_.substr(5)));
            else if (word == "loop_")
                loop();
            else if (word.starts_with("_"))
                item();
            else
                step();
        }
        if (!found_)
            cannot(name_, category_.empty() ? "it has no such block, or nothing in it"
                                            : "it has no category _" + nacre::printable(category_) + " in that block");
        return std::move(table_);
    }

private:
    void step() { kind_ = tokens_.next(token_); }

    void beginBlock(const std::string& header) {
        if (found_) {
            done_ = true;
            return;
        }
        ++blocks_;
        here_ = place_.block.empty() ? blocks_ == place_.blockIndex + 1 : lowerCase(header) == lowerCase(place_.block);
        step();
    }
    /// A file of annotations may have no block: then the whole file is one.
    bool inBlock() const { return here_ || (blocks_ == 0 && place_.blockIndex == 0 && place_.block.empty()); }

    struct Tag {
        std::string category, column;
    };
    static Tag splitTag(std::string_view token) {
        const std::size_t dot = std::min(token.find('.'), token.size());
        return {lowerCase(token.substr(1, dot - 1)), std::string(token.substr(std::min(dot + 1, token.size())))};
    }
    bool isWanted(const Tag& tag) {
        if (!inBlock()) return false;
        if (category_.empty()) category_ = tag.category;
        return tag.category == category_;
    }
    /// Index of a column among the kept ones; -1 if it is not kept.
    int findColumn(const std::string& column) const {
        const auto found = std::find_if(wanted_.begin(), wanted_.end(),
                                        [&](const std::string& one) { return lowerCase(one) == lowerCase(column); });
        return found == wanted_.end() ? -1 : static_cast<int>(found - wanted_.begin());
    }
    std::optional<std::string> value() const {
        if (kind_ == CifTokens::Kind::word && (token_ == "." || token_ == "?")) return std::nullopt;
        return std::string(token_);
    }
    void addRow() {
        if (table_.rows.size() == kMostAnnotationRows || table_.rows.size() * wanted_.size() > kMostAnnotationCells)
            cannot(name_, "it has more than " + std::to_string(kMostAnnotationRows) + " rows or " +
                              std::to_string(kMostAnnotationCells) + " values");
        table_.rows.emplace_back(wanted_.size());
    }
    void begin() {
        if (!found_) table_.columns = wanted_;
        found_ = true;
    }

    void item() {
        const Tag tag = splitTag(token_);
        step();
        if (kind_ == CifTokens::Kind::end) return;
        if (isWanted(tag)) {
            begin();
            if (table_.rows.empty()) addRow();
            if (const int column = findColumn(tag.column); column >= 0)
                table_.rows.front()[static_cast<std::size_t>(column)] = value();
        }
        step();
    }

    void loop() {
        constexpr std::size_t kMostColumns = 1000;
        std::vector<int> places;
        bool wanted = false;
        for (step(); kind_ == CifTokens::Kind::word && token_.starts_with("_"); step()) {
            const Tag tag = splitTag(token_);
            if (places.empty()) wanted = isWanted(tag);
            if (places.size() == kMostColumns) cannot(name_, "a table has more than 1000 columns");
            places.push_back(findColumn(tag.column));
        }
        if (places.empty()) return;
        if (wanted) begin();
        for (std::size_t i = 0; isValue(); ++i, step()) {
            if (!wanted) continue;
            if (i % places.size() == 0) addRow();
            const int column = places[i % places.size()];
            if (column >= 0) table_.rows.back()[static_cast<std::size_t>(column)] = value();
        }
        done_ = wanted;
    }
    bool isValue() const {
        if (kind_ != CifTokens::Kind::word) return kind_ == CifTokens::Kind::quoted;
        const std::string word = lowerCase(token_.substr(0, 5));
        return !word.starts_with("_") && word != "loop_" && word != "data_" && word != "save_";
    }

    const std::string& name_;
    CifTokens tokens_;
    const TablePlace& place_;
    std::string category_;
    std::vector<std::string> wanted_;
    CifTokens::Kind kind_ = CifTokens::Kind::end;
    std::string_view token_;
    std::size_t blocks_ = 0;
    bool here_ = false, found_ = false, done_ = false;
    AnnotationTable table_;
};

std::string nameIn(const MsgpackValue& map, const char* key) {
    const auto value = map.find(key);
    const auto text = value ? value->asText() : std::nullopt;
    return text ? std::string(*text) : std::string();
}

AnnotationTable readColumns(const std::string& name, const MsgpackValue& category,
                            const std::vector<std::string_view>& wanted) {
    const auto count = category.find("rowCount");
    const auto rows = count ? count->asInteger() : std::nullopt;
    if (!rows || *rows < 0 || *rows > static_cast<std::int64_t>(kMostAnnotationRows) ||
        static_cast<std::size_t>(*rows) * wanted.size() > kMostAnnotationCells)
        cannot(name, "its number of rows is missing, or more than " + std::to_string(kMostAnnotationRows));
    AnnotationTable table;
    table.rows.resize(static_cast<std::size_t>(*rows));
    const auto columns = category.find("columns");
    if (!columns) return table;
    std::size_t bytes = 0;
    MsgpackElements each(*columns);
    for (MsgpackValue column; each.next(column);) {
        const std::string label = nameIn(column, "name");
        const auto match = std::find_if(wanted.begin(), wanted.end(),
                                        [&](std::string_view one) { return lowerCase(one) == lowerCase(label); });
        const bool known = match != wanted.end() && std::ranges::find(table.columns, *match) == table.columns.end();
        if (!known) continue;
        table.columns.emplace_back(*match);
        try {
            BcifColumn values(column, table.rows.size(), kMostAnnotationRows);
            std::array<char, 32> buffer{};
            for (auto& row : table.rows) {
                const MmcifCell cell = values.next();
                // A binary file may refer to one long text a million times.
                bytes += cell.textSize();
                if (bytes > kMostSceneBytes) cannot(name, "its texts are too long");
                row.push_back(cell.missing() ? std::nullopt : std::optional<std::string>(cell.text(buffer)));
            }
        } catch (const PackedFault& fault) {
            cannot(name, "column " + nacre::printable(label) + ": " + nacre::printable(fault.what(), 200));
        }
    }
    return table;
}

AnnotationTable readBinary(const std::string& name, const std::string& bytes, const TablePlace& place,
                           const std::vector<std::string_view>& wanted) {
    const MsgpackValue root = parseMsgpack(name, bytes);
    const auto blocks = root.find("dataBlocks");
    if (!blocks) cannot(name, "it is neither CIF nor BinaryCIF nor JSON");
    MsgpackElements each(*blocks);
    std::size_t number = 0;
    for (MsgpackValue block; each.next(block); ++number) {
        const std::string header = nameIn(block, "header");
        if (place.block.empty() ? number != place.blockIndex : lowerCase(header) != lowerCase(place.block)) continue;
        const auto categories = block.find("categories");
        if (!categories) break;
        MsgpackElements tables(*categories);
        for (MsgpackValue category; tables.next(category);) {
            std::string label = lowerCase(nameIn(category, "name"));
            if (label.starts_with("_")) label.erase(0, 1);
            if (place.category.empty() || label == lowerCase(place.category))
                return readColumns(name, category, wanted);
        }
    }
    cannot(name, "it has no category _" + nacre::printable(place.category) + " in that block");
}

}  // namespace

AnnotationTable readCifTable(const std::string& name, const std::string& bytes, const TablePlace& place,
                             const std::vector<std::string_view>& wanted) {
    const auto first = static_cast<unsigned char>(bytes.empty() ? ' ' : bytes[0]);
    // A MessagePack map begins with a byte that no text begins with.
    if (first >= 0x80 && first != 0xef) return readBinary(name, bytes, place, wanted);
    return CifReader(name, bytes, place, wanted).read();
}

}  // namespace nacre::app::mvs
