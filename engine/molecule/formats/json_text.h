#pragma once
// Reads JSON (RFC 8259) in place, without a tree: mmJSON consists of a few large arrays, whose tree would take several
// times the text's memory.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace nacre {

/// A position in a text; a plain value, so a copy is a bookmark. Every step throws Error, with the line, where the text
/// is not JSON.
class JsonWalk {
public:
    /// @param name file name for messages; it and the text outlive this
    JsonWalk(const std::string& name, std::string_view text) : name_(&name), text_(text) {}

    /// The next non-blank character; '\0' at the end.
    char peek();
    bool accept(char wanted);
    void expect(char wanted);

    /// Reads a string; the result is in `buffer` if it has escapes, else in the text.
    std::string_view string(std::string& buffer);
    /// Reads a number as written.
    std::string_view number();
    /// Reads "null", "true" or "false".
    std::string_view word();
    /// Skips a whole value.
    void skip();

    /// Calls `visit` with each key of this object; `visit` reads the value.
    template <typename Visit>
    void object(Visit visit) {
        expect('{');
        if (accept('}')) return;
        do {
            std::string buffer;
            const std::string key(string(buffer));
            expect(':');
            visit(key);
        } while (accept(','));
        expect('}');
    }

    [[noreturn]] void fail(const std::string& why) const;
    std::uint64_t line() const;

private:
    void escape(std::string& buffer);
    std::uint32_t hexDigits();
    char take();

    const std::string* name_;
    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace nacre
