#include "engine/molecule/formats/json_text.h"

#include <algorithm>

#include "engine/molecule/formats/text_encoding.h"
#include "engine/molecule/text.h"

namespace nacre {

void JsonWalk::fail(const std::string& why) const { cannotRead(*name_, "not valid JSON: " + why, line()); }

std::uint64_t JsonWalk::line() const {
    const std::string_view before = text_.substr(0, at_);
    return 1 + static_cast<std::uint64_t>(std::count(before.begin(), before.end(), '\n'));
}

char JsonWalk::peek() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n' || text_[at_] == '\t' || text_[at_] == '\r'))
        ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
}

bool JsonWalk::accept(char wanted) {
    if (peek() != wanted || at_ == text_.size()) return false;
    ++at_;
    return true;
}

void JsonWalk::expect(char wanted) {
    if (accept(wanted)) return;
    const std::string found = at_ == text_.size() ? "the end" : "'" + printable(text_.substr(at_, 1)) + "'";
    fail("expected '" + std::string(1, wanted) + "', found " + found);
}

char JsonWalk::take() {
    if (at_ == text_.size()) fail("a string is not closed");
    return text_[at_++];
}

std::string_view JsonWalk::string(std::string& buffer) {
    expect('"');
    const std::size_t begin = at_;
    bool escaped = false;
    for (;;) {
        const char c = take();
        if (c == '"') break;
        if (static_cast<unsigned char>(c) < ' ') fail("a control character in a string");
        if (c == '\\' && !escaped) {
            escaped = true;
            buffer.assign(text_.substr(begin, at_ - 1 - begin));
        }
        if (c == '\\')
            escape(buffer);
        else if (escaped)
            buffer += c;
    }
    return escaped ? std::string_view(buffer) : text_.substr(begin, at_ - 1 - begin);
}

void JsonWalk::escape(std::string& buffer) {
    static constexpr std::string_view kLetters = "\"\\/bfnrt", kMeanings = "\"\\/\b\f\n\r\t";
    const char letter = take();
    if (const std::size_t which = kLetters.find(letter); which != std::string_view::npos) {
        buffer += kMeanings[which];
        return;
    }
    if (letter != 'u') fail("an unknown escape in a string");
    std::uint32_t character = hexDigits();
    if (character >= 0xD800 && character < 0xDC00) {  // the first half of a pair
        if (take() != '\\' || take() != 'u') fail("half a character in a string");
        const std::uint32_t second = hexDigits();
        if (second < 0xDC00 || second >= 0xE000) fail("half a character in a string");
        character = 0x10000 + ((character - 0xD800) << 10) + (second - 0xDC00);
    } else if (character >= 0xDC00 && character < 0xE000) {
        fail("half a character in a string");
    }
    appendUtf8(buffer, character);
}

std::uint32_t JsonWalk::hexDigits() {
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i) {
        const char c = take();
        const char lower = static_cast<char>(c | 0x20);
        if (!isDigit(c) && (lower < 'a' || lower > 'f')) fail("four hexadecimal digits are missing");
        value = value << 4 | static_cast<std::uint32_t>(isDigit(c) ? c - '0' : lower - 'a' + 10);
    }
    return value;
}

std::string_view JsonWalk::number() {
    peek();
    const std::size_t begin = at_;
    const auto here = [&](std::string_view any) {
        return at_ < text_.size() && any.find(text_[at_]) != std::string_view::npos;
    };
    const auto digits = [&] {
        const std::size_t first = at_;
        while (at_ < text_.size() && isDigit(text_[at_])) ++at_;
        if (at_ == first) fail("expected a value");
    };
    if (here("-")) ++at_;
    if (here("0"))
        ++at_;
    else
        digits();
    if (here(".")) {
        ++at_;
        digits();
    }
    if (here("eE")) {
        ++at_;
        if (here("+-")) ++at_;
        digits();
    }
    return text_.substr(begin, at_ - begin);
}

std::string_view JsonWalk::word() {
    peek();
    for (const std::string_view known : {"null", "true", "false"})
        if (text_.substr(at_, known.size()) == known) {
            at_ += known.size();
            return known;
        }
    fail("expected a value");
}

void JsonWalk::skip() {
    constexpr std::size_t kDeepest = 64;
    std::string open;  // pending closing brackets
    std::string buffer;
    do {
        const char c = peek();
        if (c == '{' || c == '[') {
            if (open.size() == kDeepest) fail("it is nested more than " + std::to_string(kDeepest) + " deep");
            ++at_;
            open += c == '{' ? '}' : ']';
            if (!accept(open.back())) {
                if (open.back() == ']') continue;
                string(buffer);
                expect(':');
                continue;
            }
            open.pop_back();
        } else if (c == '"') {
            string(buffer);
        } else if (isDigit(c) || c == '-') {
            number();
        } else {
            word();
        }
        // A value has ended, and perhaps its containers.
        while (!open.empty() && !accept(',')) {
            expect(open.back());
            open.pop_back();
        }
        if (!open.empty() && open.back() == '}') {
            string(buffer);
            expect(':');
        }
    } while (!open.empty());
}

}  // namespace nacre
