#pragma once
// Walks through JSON (RFC 8259) where it lies, without a tree: mmJSON is a few large arrays, of which a tree would take
// a multiple of the text.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace nacre {

/// Stands at a place of a text; a plain value, so that a copy remembers the place. Every step throws Error, with the
/// line, where the text is no JSON.
class JsonWalk {
public:
    /// @param name file name for messages; it and the text outlive this
    JsonWalk(const std::string& name, std::string_view text) : name_(&name), text_(text) {}

    /// The next character that is no blank; '\0' at the end.
    char peek();
    bool accept(char wanted);
    void expect(char wanted);

    /// Passes a string; what it says, in `buffer` if it has escapes, else where it lies.
    std::string_view string(std::string& buffer);
    /// Passes a number as it is written.
    std::string_view number();
    /// Passes "null", "true" or "false".
    std::string_view word();
    /// Passes a whole value, whatever it is.
    void skip();

    /// Calls with each key of an object that begins here; `visit` passes the value.
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
