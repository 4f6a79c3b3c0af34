// BinaryCIF: the categories of mmCIF in columns, packed with MessagePack.
#include <algorithm>

#include "engine/molecule/formats/bcif_column.h"
#include "engine/molecule/formats/mmcif_model.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

using Kind = MsgpackValue::Kind;

class BcifWalker {
public:
    BcifWalker(const std::string& name, std::size_t bytes, std::size_t maxAtoms, MmcifModel& model)
        : name_(name), bytes_(bytes), mostStrings_(kFewStrings + maxAtoms), model_(model) {}

    void document(const MsgpackValue& root) {
        const auto blocks = root.find("dataBlocks");
        if (!blocks || !blocks->is(Kind::array)) fail("it has no dataBlocks, so it is not BinaryCIF");
        MsgpackElements elements(*blocks);
        for (MsgpackValue block; elements.next(block);) {
            model_.beginBlock();
            const auto categories = block.find("categories");
            if (!categories || !categories->is(Kind::array)) fail("a data block has no categories");
            MsgpackElements each(*categories);
            for (MsgpackValue content; each.next(content);) category(content);
        }
    }

private:
    [[noreturn]] void fail(const std::string& why) const { cannotRead(name_, why); }

    std::string readName(const MsgpackValue& map) const {
        const auto named = map.find("name");
        const auto text = named ? named->asText() : std::nullopt;
        if (!text) fail("a category or column has no name");
        return lowerCase(*text);
    }

    void category(const MsgpackValue& content) {
        std::string name = readName(content);
        if (startsWith(name, "_")) name.erase(0, 1);
        if (!MmcifModel::isKept(name)) return;
        std::vector<std::string> names;
        std::vector<MsgpackValue> values;
        const auto columns = content.find("columns");
        if (!columns || !columns->is(Kind::array)) fail("the category " + printable(name) + " has no columns");
        MsgpackElements elements(*columns);
        for (MsgpackValue column; elements.next(column);) {
            std::string label = readName(column);
            const bool repeated = std::find(names.begin(), names.end(), label) != names.end();
            if (repeated || !MmcifModel::isKept(name, label)) continue;
            if (names.size() == kMaxColumns) fail("the category _" + printable(name) + " has too many columns");
            names.push_back(std::move(label));
            values.push_back(column);
        }
        const std::size_t rows = rowCount(content, name);
        if (values.empty() || rows == 0 || !model_.beginCategory(name, names, 0)) return;
        if (name != "atom_site") model_.expectRows(rows, names.size());
        addRows(name, names, values, rows);
    }

    /// A row takes at least one byte of the file: true for real files, and a limit for hostile ones.
    std::size_t rowCount(const MsgpackValue& content, const std::string& category) const {
        const auto value = content.find("rowCount");
        const auto rows = value ? value->asInteger() : std::nullopt;
        if (!rows || *rows < 0 || static_cast<std::uint64_t>(*rows) > std::min(bytes_, kMaxRows))
            fail("the number of rows of _" + printable(category) + " is missing or impossible");
        return static_cast<std::size_t>(*rows);
    }

    void addRows(const std::string& category, const std::vector<std::string>& names,
                 const std::vector<MsgpackValue>& values, std::size_t rows) {
        std::vector<BcifColumn> columns;
        columns.reserve(values.size());
        std::size_t at = 0;  // current column
        try {
            for (; at < values.size(); ++at) columns.emplace_back(values[at], rows, mostStrings_);
            std::vector<MmcifCell> row(columns.size());
            for (std::size_t i = 0; i < rows; ++i) {
                for (at = 0; at < columns.size(); ++at) row[at] = columns[at].next();
                model_.addRow(row, 0);
            }
            for (at = 0; at < columns.size(); ++at) columns[at].finish();
        } catch (const PackedFault& fault) {
            fail("column _" + printable(category) + "." + printable(names[at]) + ": " + printable(fault.what(), 200));
        }
    }

    static constexpr std::size_t kMaxColumns = 1000;        // the dictionary's largest category has some 120
    static constexpr std::size_t kMaxRows = 4 * kMaxAtoms;  // all models together
    static constexpr std::size_t kFewStrings = 100'000;     // different ones in a column; always allowed

    const std::string& name_;
    std::size_t bytes_, mostStrings_;
    MmcifModel& model_;
};

}  // namespace

std::vector<Molecule> readBcif(const std::string& name, std::string_view bytes, const ReadOptions& options,
                               int lastModel) {
    MmcifModel model(name, bytes, options, lastModel);
    BcifWalker(name, bytes.size(), options.maxAtoms, model).document(parseMsgpack(name, bytes));
    return model.finish("bcif");
}

}  // namespace nacre
