// mmJSON: the categories of mmCIF as columns, {"data_ID": {"category": {"column": [value, ...], ...}, ...}}.
#include <optional>

#include "engine/molecule/formats/json_text.h"
#include "engine/molecule/formats/mmcif_model.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

constexpr std::size_t kMaxColumns = 1000;  // the dictionary's largest category has some 120

class MmjsonReader {
public:
    MmjsonReader(const std::string& name, std::string_view text, MmcifModel& model)
        : name_(name), walk_(name, text), model_(model) {}

    void run() {
        std::size_t blocks = 0;
        if (walk_.peek() != '{') {
            walk_.skip();
            notMmjson();
        }
        walk_.object([&](const std::string& key) {
            if (++blocks > 1 || !startsWith(key, "data_") || walk_.peek() != '{') {
                walk_.skip();
                notMmjson();
            }
            block();
        });
        if (blocks != 1) notMmjson();
        if (walk_.peek() != '\0') walk_.fail("something follows its end");
    }

private:
    [[noreturn]] void fail(const std::string& why) const { cannotRead(name_, why); }
    [[noreturn]] void notMmjson() const {
        fail("this JSON is not mmJSON: its only top-level key should begin with data_");
    }

    void block() {
        model_.beginBlock();
        walk_.object([&](const std::string& key) { category(lowerCase(key)); });
    }

    void category(const std::string& name) {
        if (walk_.peek() != '{') fail("the category " + printable(name) + " is not an object");
        std::vector<std::string> names;
        std::vector<JsonWalk> columns;  // each at its next value
        std::optional<std::size_t> rows;
        walk_.object([&](const std::string& key) {
            if (names.size() == kMaxColumns) fail("the category " + printable(name) + " has too many columns");
            names.push_back(lowerCase(key));
            columns.push_back(walk_);
            const std::optional<std::size_t> length = passArray();
            if (!length || rows.value_or(*length) != *length)
                fail("the columns of the category " + printable(name) + " are not arrays of one length");
            rows = length;
        });
        if (columns.empty() || !model_.beginCategory(name, names, 0)) return;
        std::vector<std::string> texts(columns.size());
        std::vector<MmcifCell> row(columns.size());
        for (std::size_t i = 0; i < *rows; ++i) {
            for (std::size_t j = 0; j < columns.size(); ++j) {
                columns[j].expect(i == 0 ? '[' : ',');
                row[j] = cell(columns[j], texts[j]);
            }
            model_.addRow(row, 0);
        }
    }

    /// Number of values in the array here; empty if there is no array.
    std::optional<std::size_t> passArray() {
        if (!walk_.accept('[')) {
            walk_.skip();
            return std::nullopt;
        }
        std::size_t length = 0;
        if (walk_.accept(']')) return length;
        do {
            walk_.skip();
            ++length;
        } while (walk_.accept(','));
        walk_.expect(']');
        return length;
    }

    /// null means '?', false means '.'.
    MmcifCell cell(JsonWalk& walk, std::string& buffer) const {
        const char first = walk.peek();
        if (first == '"') return walk.string(buffer);
        if (first == 'n' || first == 'f') {
            walk.word();
            return {};
        }
        if (first == 't' || first == '{' || first == '[') fail("a value is neither text nor number");
        return walk.number();
    }

    const std::string& name_;
    JsonWalk walk_;
    MmcifModel& model_;
};

}  // namespace

std::vector<Molecule> readMmjson(const std::string& name, std::string_view text, const ReadOptions& options,
                                 int lastModel) {
    MmcifModel model(name, text, options, lastModel);
    MmjsonReader(name, text, model).run();
    return model.finish("mmjson");
}

}  // namespace nacre
