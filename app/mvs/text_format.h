#pragma once
// Texts of label_from_* and tooltip_from_*: "{name}: {score:.2f}", in the syntax of Python's f-strings.

#include <optional>
#include <string>
#include <vector>

namespace nacre::app::mvs {

class TextFormat {
public:
    /// @throws std::invalid_argument with the reason
    explicit TextFormat(const std::string& format);

    /// The fields in the text, in order.
    const std::vector<std::string>& fields() const { return fields_; }
    /// The text; empty if a field has no value. @param values  the first is for fields without a name
    /// @param from  index of the value of fields()[0]
    std::optional<std::string> of(const std::vector<std::optional<std::string>>& values, std::size_t from) const;

private:
    struct Style {
        char fill = ' ', align = 0, sign = '-', type = 's';  ///< align 0: by the type
        int width = 0, precision = 6;
        bool commas = false;
    };
    struct Part {
        std::string words;  ///< before the field
        std::size_t field;  ///< index into `fields_`, or kFirst
        Style style;
    };
    static constexpr std::size_t kFirst = SIZE_MAX;
    static Style parseStyle(const std::string& text);
    static std::string styled(const std::string& value, const Style& style);

    std::vector<Part> parts_;
    std::string end_;
    std::vector<std::string> fields_;
};

}  // namespace nacre::app::mvs
