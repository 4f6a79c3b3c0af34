#include "engine/molecule/formats/content.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <utility>

#include "engine/error.h"
#include "engine/molecule/formats/decompress.h"
#include "engine/molecule/formats/detect.h"
#include "engine/molecule/formats/model_texts.h"
#include "engine/molecule/formats/text_encoding.h"
#include "engine/molecule/text.h"

namespace nacre {
namespace {

constexpr std::size_t kTellingBytes = std::size_t{64} << 10;  // tells the format

bool isBinary(Format format) { return format == Format::bcif || format == Format::mmtf; }

Error tooLarge(const std::string& name, std::size_t maxBytes) {
    return Error("cannot read molecule", name, "it is larger than the limit of " + std::to_string(maxBytes) + " bytes");
}

std::string headOf(const TextSource& text) {
    std::string head;
    appendText(head, text, {0, std::min<std::uint64_t>(kTellingBytes, text.size)});
    return head;
}

/// Text in a format that is read by lines, and told by its beginning; else nothing.
std::optional<TextContent> plainText(const std::string& name, TextSource text, const ReadOptions& options) {
    const std::string head = headOf(text);
    if (!compressionOf(head).empty() || startsWith(head, "\xEF\xBB\xBF") || utf8FromUtf16(head)) return std::nullopt;
    const std::optional<Format> binary = detectBinaryFormat(head);
    if (binary) return std::nullopt;
    return TextContent{std::move(text), options.format ? *options.format : detectFormat(name, head)};
}

/// Takes in what is inflated: in memory, and where that is much and has several models in a temporary file.
class Inflated {
public:
    Inflated(const std::string& name, const ReadOptions& options) : name_(name), options_(options) {}

    void take(std::string_view part) {
        if (file_) {
            if (!file_->append(part.data(), part.size()))
                throw Error("cannot read molecule", name_, "no room for a temporary file of its text");
            return;
        }
        if (held_.size() + part.size() > held_.capacity()) held_.reserve(2 * held_.size() + part.size());
        held_.append(part);
        if (judged_ || held_.size() <= options_.heldText) return;
        judged_ = true;
        if (!severalModels()) return;
        file_ = ByteFile::temporary();
        if (file_ && file_->append(held_.data(), held_.size()))
            held_ = {};
        else
            file_.reset();
    }
    const std::shared_ptr<ByteFile>& file() const { return file_; }
    std::string& held() { return held_; }

private:
    bool severalModels() const {
        const TextSource begun = textInMemory(std::string_view(held_).substr(0, held_.rfind('\n') + 1));
        try {
            const std::optional<TextContent> content = plainText(name_, begun, options_);
            return content && modelTexts(content->format, begun).models.size() > 1;
        } catch (const Error&) {
            return false;
        }
    }

    const std::string& name_;
    const ReadOptions& options_;
    std::string held_;
    std::shared_ptr<ByteFile> file_;
    bool judged_ = false;
};

}  // namespace

void unifyLineEnds(std::string& text) {
    std::size_t from = text.find('\r');
    if (from == std::string::npos) return;
    std::size_t to = from;
    for (; from < text.size(); ++from) {
        const bool pair = text[from] == '\r' && from + 1 < text.size() && text[from + 1] == '\n';
        if (!pair) text[to++] = text[from] == '\r' ? '\n' : text[from];
    }
    text.resize(to);
}

FileContent contentOf(const std::string& name, std::string bytes, const ReadOptions& options) {
    if (!compressionOf(bytes).empty()) bytes = decompress(name, bytes, options.maxBytes);
    if (startsWith(bytes, "\xEF\xBB\xBF")) bytes.erase(0, 3);
    if (bytes.size() > options.maxBytes) throw tooLarge(name, options.maxBytes);
    if (auto utf8 = utf8FromUtf16(bytes)) bytes = std::move(*utf8);
    if (bytes.empty()) throw Error("cannot read molecule", name, "it is empty");
    std::optional<Format> known = options.format;
    if (!known) known = detectBinaryFormat(bytes);
    if (!known || !isBinary(*known)) unifyLineEnds(bytes);
    const Format format = known ? *known : detectFormat(name, bytes);
    return {std::move(bytes), format};
}

std::optional<TextContent> textContentOf(const std::string& path, const ReadOptions& options, std::string& inflated) {
    const std::shared_ptr<ByteFile> file = ByteFile::open(path);
    if (!file || file->size() == 0 || file->size() > options.maxBytes) return std::nullopt;
    TextSource text = textInFile(file);
    if (compressionOf(headOf(text)).empty()) {
        if (file->size() <= options.heldText) return std::nullopt;
        return plainText(path, std::move(text), options);
    }
    std::string bytes(static_cast<std::size_t>(file->size()), '\0');
    file->read(0, bytes.data(), bytes.size());
    Inflated taken(path, options);
    decompress(path, bytes, options.maxBytes, [&](std::string_view part) { taken.take(part); });
    if (taken.file()) return plainText(path, textInFile(taken.file()), options);
    inflated = std::move(taken.held());
    return std::nullopt;
}

std::optional<TextContent> textContentOf(const std::string& name, std::shared_ptr<const std::string> bytes,
                                         const ReadOptions& options) {
    TextSource text = textInMemory(*bytes);
    text.read = [read = text.read, bytes](std::uint64_t at, char* to, std::size_t count) { read(at, to, count); };
    return plainText(name, std::move(text), options);
}

std::string readAll(std::FILE* file, const std::string& name, std::size_t maxBytes, std::uintmax_t expected) {
    constexpr std::size_t kChunk = std::size_t{1} << 20;
    std::string bytes;
    bytes.reserve(static_cast<std::size_t>(std::min<std::uintmax_t>(expected, maxBytes)) + kChunk);
    for (;;) {
        const std::size_t size = bytes.size();
        if (size > maxBytes) throw tooLarge(name, maxBytes);
        const std::size_t chunk = std::min(kChunk, maxBytes - size + 1);
        if (size + chunk > bytes.capacity()) bytes.reserve(std::max(std::min(2 * size, maxBytes) + 1, size + chunk));
        bytes.resize(size + chunk);
        const std::size_t got = std::fread(bytes.data() + size, 1, chunk, file);
        bytes.resize(size + got);
        if (got == 0) break;
    }
    if (std::ferror(file)) throw Error("cannot read molecule", name, std::strerror(errno));
    return bytes;
}

}  // namespace nacre
