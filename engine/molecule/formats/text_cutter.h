#pragma once
// Iterates over the lines of a text, and splits it between them.

#include <algorithm>
#include <string>
#include <string_view>

#include "engine/molecule/formats/text_source.h"

namespace nacre {

class TextCutter {
public:
    explicit TextCutter(const TextSource& text) : text_(text) { findLine(); }

    bool atEnd() const { return place() == text_.size; }
    /// Without its line end. Valid until pass().
    std::string_view line() const { return std::string_view(piece_).substr(from_, length_); }
    void pass() {
        from_ = std::min(from_ + length_ + 1, piece_.size());
        findLine();
    }
    /// Skips lines; false if there are fewer.
    bool pass(std::int64_t lines) {
        for (; lines > 0 && !atEnd(); --lines) pass();
        return lines == 0;
    }
    std::uint64_t place() const { return pieceAt_ + from_; }
    TextSpan since(std::uint64_t begin) const { return {begin, place()}; }

private:
    static constexpr std::size_t kPiece = std::size_t{1} << 20;

    void findLine() {
        for (;;) {
            const std::size_t end = piece_.find('\n', from_);
            length_ = std::min(end, piece_.size()) - from_;
            const std::uint64_t next = pieceAt_ + piece_.size();
            if (end != std::string::npos || next == text_.size) return;
            piece_.erase(0, from_);
            pieceAt_ += from_;
            from_ = 0;
            const std::size_t held = piece_.size();
            const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(kPiece, text_.size - next));
            piece_.resize(held + count);
            text_.read(next, piece_.data() + held, count);
        }
    }

    const TextSource& text_;
    std::string piece_;
    std::uint64_t pieceAt_ = 0;
    std::size_t from_ = 0, length_ = 0;
};

}  // namespace nacre
