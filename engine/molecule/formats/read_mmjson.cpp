#include <gemmi/json.hpp>
#include <optional>

#include "engine/error.h"
#include "engine/molecule/formats/mmcif_model.h"
#include "engine/molecule/formats/readers.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

// The parser takes up to 32 bytes for each value, and a value may be two bytes of text.
constexpr std::size_t kMaxText = std::size_t{256} << 20;

class JsonWalker {
public:
    JsonWalker(const std::string& name, MmcifModel& model) : name_(name), model_(model) {}

    void document(const sajson::document& json) {
        const sajson::value root = json.get_root();
        if (root.get_type() != sajson::TYPE_OBJECT || root.get_length() != 1 ||
            root.get_object_key(0).as_string().substr(0, 5) != "data_" ||
            root.get_object_value(0).get_type() != sajson::TYPE_OBJECT)
            fail("this JSON is not mmJSON: its only top-level key should begin with data_");
        const sajson::value block = root.get_object_value(0);
        model_.beginBlock();
        for (std::size_t i = 0; i < block.get_length(); ++i)
            category(lowerCase(block.get_object_key(i).as_string()), block.get_object_value(i));
    }

private:
    [[noreturn]] void fail(const std::string& why) const { throw Error("cannot read molecule", name_, why); }

    void category(const std::string& name, const sajson::value& content) {
        if (content.get_type() != sajson::TYPE_OBJECT) fail("the category " + printable(name) + " is not an object");
        std::vector<std::string> columns;
        std::vector<sajson::value> arrays;
        for (std::size_t i = 0; i < content.get_length(); ++i) {
            columns.push_back(lowerCase(content.get_object_key(i).as_string()));
            arrays.push_back(content.get_object_value(i));
            const sajson::value& array = arrays.back();
            if (array.get_type() != sajson::TYPE_ARRAY || array.get_length() != arrays.front().get_length())
                fail("the columns of the category " + printable(name) + " are not arrays of one length");
        }
        if (arrays.empty() || !model_.beginCategory(name, columns, 0)) return;
        std::vector<std::string> texts(arrays.size());
        std::vector<MmcifCell> row(arrays.size());
        for (std::size_t i = 0; i < arrays.front().get_length(); ++i) {
            for (std::size_t j = 0; j < arrays.size(); ++j) row[j] = cell(arrays[j].get_array_element(i), texts[j]);
            model_.addRow(row, 0);
        }
    }

    /// null stands for '?', false for '.'.
    MmcifCell cell(const sajson::value& value, std::string& text) const {
        switch (value.get_type()) {
            case sajson::TYPE_NULL:
            case sajson::TYPE_FALSE:
                return {};
            case sajson::TYPE_DOUBLE:
            case sajson::TYPE_STRING:
                text = value.as_string();
                return std::string_view(text);
            default:
                fail("a value is neither text nor number");
        }
    }

    const std::string& name_;
    MmcifModel& model_;
};

}  // namespace

Molecule readMmjson(const std::string& name, std::string_view text, const ReadOptions& options) {
    if (text.size() > kMaxText)
        throw Error("cannot read molecule", name,
                    "mmJSON of more than " + std::to_string(kMaxText) + " bytes; use mmCIF");
    std::string buffer(text);  // the parser writes into it
    const sajson::document json =
        sajson::parse(sajson::dynamic_allocation(), sajson::mutable_string_view(buffer.size(), buffer.data()));
    if (!json.is_valid())
        throw Error("cannot read molecule", name,
                    "not valid JSON: " + printable(json.get_error_message_as_string(), 200), json.get_error_line());
    MmcifModel model(name, options);
    JsonWalker(name, model).document(json);
    return model.finish("mmjson");
}

}  // namespace nacre
