#pragma once
// Expat for code with exceptions, and for texts of any length.

#include <expat.h>

#include <cstdint>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <string_view>

namespace nacre {

class ExpatParser {
public:
    /// @param user  what handlers are called with
    explicit ExpatParser(void* user) : parser_(XML_ParserCreate(nullptr), XML_ParserFree) {
        if (!parser_) throw std::bad_alloc();
        XML_SetUserData(get(), user);
    }
    XML_Parser get() const { return parser_.get(); }

    std::uint64_t line() const {
#if XML_MAJOR_VERSION > 2 || (XML_MAJOR_VERSION == 2 && XML_MINOR_VERSION >= 9)
        return XML_GetCurrentLineNumber64(get());
#else
        return XML_GetCurrentLineNumber(get());
#endif
    }

    /// Parses the next part of a document. @returns why it is not XML; empty if it is @throws what a handler threw
    std::string parse(std::string_view text, bool last) {
        constexpr std::size_t kPart = std::size_t{1} << 30;  // Expat counts in int
        do {
            const std::string_view part = text.substr(0, kPart);
            text.remove_prefix(part.size());
            const auto status = XML_Parse(get(), part.data(), static_cast<int>(part.size()),
                                          last && text.empty() ? XML_TRUE : XML_FALSE);
            if (thrown_) std::rethrow_exception(thrown_);
            if (status != XML_STATUS_OK) return XML_ErrorString(XML_GetErrorCode(get()));
        } while (!text.empty());
        return "";
    }

    /// Runs the work of a handler, which may throw: no exception may pass through Expat, which is C.
    template <typename Work>
    void guard(Work work) {
        if (thrown_) return;
        try {
            work();
        } catch (...) {
            thrown_ = std::current_exception();
            XML_StopParser(get(), XML_FALSE);
        }
    }

private:
    std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser_;
    std::exception_ptr thrown_;
};

}  // namespace nacre
