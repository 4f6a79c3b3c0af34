#include "engine/molecule/formats/content.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "engine/error.h"
#include "engine/molecule/formats/decompress.h"
#include "engine/molecule/formats/detect.h"
#include "engine/molecule/formats/format_table.h"
#include "engine/molecule/formats/text_encoding.h"
#include "engine/molecule/text.h"

namespace nacre {
namespace {

constexpr std::size_t kTellingBytes = std::size_t{64} << 10;  // enough to detect the format

[[noreturn]] void refuseLarge(const std::string& name, std::size_t maxBytes) {
    cannotRead(name, "it is larger than the limit of " + std::to_string(maxBytes) + " bytes");
}

std::string readHead(const TextSource& text) {
    std::string head;
    appendText(head, text, {0, std::min<std::uint64_t>(kTellingBytes, text.size)});
    return head;
}

/// A text that is read by lines, and the positions of its models; else empty.
std::optional<Content> plainText(const std::string& name, TextSource text, const ReadOptions& options) {
    const std::string head = readHead(text);
    if (!detectCompression(head).empty() || startsWith(head, "\xEF\xBB\xBF") || utf8FromUtf16(head))
        return std::nullopt;
    if (detectBinaryFormat(head)) return std::nullopt;
    Content content{name, options.format ? *options.format : detectFormat(name, head), nullptr, std::move(text), {}};
    content.spans = modelSpans(content.format, content.text);
    return content;
}

/// As above, if its models can be separated, so that each is read with little of the others' text.
std::optional<Content> severalModels(const std::string& name, TextSource text, const ReadOptions& options) {
    constexpr std::uint64_t kMostAround = std::uint64_t{32} << 20, kMostBytesOfPasses = std::uint64_t{1} << 32;
    std::optional<Content> content = plainText(name, std::move(text), options);
    if (!content || !content->spans.complete || content->spans.models.size() < 2) return std::nullopt;
    const std::uint64_t around = content->spans.around();
    if (around > kMostAround || content->spans.models.size() > kMostBytesOfPasses / (around + 1)) return std::nullopt;
    return content;
}

/// Collects inflated data: in memory, or, if it is large and has several models, in a temporary file.
class Inflated {
public:
    Inflated(const std::string& name, const ReadOptions& options) : name_(name), options_(options) {}

    void take(std::string_view part) {
        if (file_) {
            if (!file_->append(part.data(), part.size())) cannotRead(name_, "no room for a temporary file of its text");
            return;
        }
        if (held_.size() + part.size() > held_.capacity()) held_.reserve(2 * held_.size() + part.size());
        held_.append(part);
        if (judged_ || held_.size() <= options_.heldText) return;
        judged_ = true;
        if (!hasSeveralModels()) return;
        file_ = ByteFile::temporary();
        if (file_ && file_->append(held_.data(), held_.size()))
            held_ = {};
        else
            file_.reset();
    }
    const std::shared_ptr<ByteFile>& file() const { return file_; }
    std::string& held() { return held_; }

private:
    bool hasSeveralModels() const {
        const TextSource begun = textInMemory(std::string_view(held_).substr(0, held_.rfind('\n') + 1));
        try {
            const std::optional<Content> content = plainText(name_, begun, options_);
            return content && content->spans.models.size() > 1;
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

struct CloseFile {
    void operator()(std::FILE* file) const {
        if (file != stdin) std::fclose(file);
    }
};

/// Reads to the end, up to the limit: a device or pipe may be endless.
std::string readAll(std::FILE* file, const std::string& name, const ReadOptions& options) {
    constexpr std::size_t kChunk = std::size_t{1} << 20;
    struct stat status {};
    const bool plain = fstat(fileno(file), &status) == 0 && S_ISREG(status.st_mode);
    const std::uint64_t expected = plain ? static_cast<std::uint64_t>(status.st_size) : 0;
    std::string bytes;
    bytes.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(expected, options.maxBytes)) + 1);
    for (;;) {
        const std::size_t size = bytes.size();
        if (size > options.maxBytes) refuseLarge(name, options.maxBytes);
        // One byte more than expected detects the end. Each byte is cleared before it is read, even for a small file.
        const auto rest = static_cast<std::size_t>(expected > size ? expected - size + 1 : kChunk);
        const std::size_t chunk = std::min({kChunk, rest, options.maxBytes - size + 1});
        if (size + chunk > bytes.capacity())
            bytes.reserve(std::max(std::min(2 * size, options.maxBytes) + 1, size + chunk));
        bytes.resize(size + chunk);
        const std::size_t got = std::fread(bytes.data() + size, 1, chunk, file);
        bytes.resize(size + got);
        if (got < chunk) break;
    }
    if (std::ferror(file)) cannotRead(name, std::strerror(errno));
    return bytes;
}

/// A long text of several models, or an inflated one; else empty.
std::optional<Content> openSeveral(const std::string& path, const ReadOptions& options) {
    const std::shared_ptr<ByteFile> file = ByteFile::open(path);
    if (!file || file->size() == 0 || file->size() > options.maxBytes) return std::nullopt;
    TextSource text = textInFile(file);
    if (detectCompression(readHead(text)).empty())
        return file->size() > options.heldText ? severalModels(path, std::move(text), options) : std::nullopt;
    std::string bytes(static_cast<std::size_t>(file->size()), '\0');
    file->read(0, bytes.data(), bytes.size());
    Inflated taken(path, options);
    decompress(path, bytes, options.maxBytes, [&](std::string_view part) { taken.take(part); });
    if (!taken.file()) return makeContent(path, std::move(taken.held()), options);
    std::optional<Content> content = severalModels(path, textInFile(taken.file()), options);
    return content ? content : makeContent(path, std::move(bytes), options);
}

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

Content makeContent(const std::string& name, std::string bytes, const ReadOptions& options) {
    if (!detectCompression(bytes).empty()) bytes = decompress(name, bytes, options.maxBytes);
    if (startsWith(bytes, "\xEF\xBB\xBF")) bytes.erase(0, 3);
    if (bytes.size() > options.maxBytes) refuseLarge(name, options.maxBytes);
    if (auto utf8 = utf8FromUtf16(bytes)) bytes = std::move(*utf8);
    if (bytes.empty()) cannotRead(name, "it is empty");
    std::optional<Format> known = options.format;
    if (!known) known = detectBinaryFormat(bytes);
    if (!known || !formatRow(*known).binary) unifyLineEnds(bytes);
    const Format format = known ? *known : detectFormat(name, bytes);
    const auto held = std::make_shared<const std::string>(std::move(bytes));
    return {name, format, held, textInMemory(*held), {}};
}

Content openContent(const std::string& path, const ReadOptions& options) {
    if (path == "-") return makeContent("standard input", readAll(stdin, "standard input", options), options);
    const std::string shown = printable(path, kMaxMessage);
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) cannotRead(shown, "it is a folder");
    const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
    if (!file) cannotRead(shown, std::strerror(errno));
    if (std::optional<Content> several = openSeveral(path, options)) return std::move(*several);
    return makeContent(path, readAll(file.get(), shown, options), options);
}

Content heldWhole(const Content& content, const ReadOptions& options) {
    std::string text;
    appendText(text, content.text, {0, content.text.size});
    ReadOptions known = options;
    known.format = content.format;
    return makeContent(content.name, std::move(text), known);
}

}  // namespace nacre
