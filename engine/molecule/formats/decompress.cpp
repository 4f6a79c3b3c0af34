#include "engine/molecule/formats/decompress.h"

#include <bzlib.h>
#include <lzma.h>
#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <new>
#include <stdexcept>

#include "engine/error.h"

namespace nacre {

namespace {

constexpr std::size_t kFreeOfRatio = std::size_t{64} << 20;
constexpr std::size_t kMaxRatio = 100;
constexpr std::size_t kChunk = std::size_t{256} << 10;
constexpr std::size_t kMostInput = std::size_t{1} << 30;  // at once; some libraries count in 32 bits
// Dictionary size of xz and zstd; only its decoded part takes memory.
constexpr std::uint64_t kMostDictionary = std::uint64_t{256} << 20;

constexpr const char* kWrongChecksum = "wrong checksum (CRC): the file is damaged";

/// Why a stream cannot be inflated.
struct Damage : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Input and output of a decompression step; the step advances both.
struct Window {
    const char* in;
    std::size_t inLeft;
    char* out;
    std::size_t outLeft;
};

/// A step of a library whose stream has zlib's fields. @return the step's result
template <typename Stream, typename Step>
auto runStep(Stream& stream, Window& w, const Step& step) {
    stream.next_in = reinterpret_cast<decltype(stream.next_in)>(const_cast<char*>(w.in));
    stream.avail_in = static_cast<decltype(stream.avail_in)>(w.inLeft);
    stream.next_out = reinterpret_cast<decltype(stream.next_out)>(w.out);
    stream.avail_out = static_cast<decltype(stream.avail_out)>(w.outLeft);
    const auto state = step(&stream);
    w = {reinterpret_cast<const char*>(stream.next_in), stream.avail_in, reinterpret_cast<char*>(stream.next_out),
         stream.avail_out};
    return state;
}

/// Inflates one member.
class Member {
public:
    virtual ~Member() = default;
    /// @return whether the member has ended. @throws Damage
    virtual bool step(Window& window) = 0;
};

class GzipMember final : public Member {
public:
    GzipMember() {
        constexpr int kGzipOnly = 16 + MAX_WBITS;
        if (inflateInit2(&stream_, kGzipOnly) != Z_OK) throw std::bad_alloc();
    }
    ~GzipMember() override { inflateEnd(&stream_); }

    bool step(Window& w) override {
        const int state = runStep(stream_, w, [](z_stream* stream) { return inflate(stream, Z_NO_FLUSH); });
        if (state == Z_DATA_ERROR && stream_.msg && std::string_view(stream_.msg) == "incorrect data check")
            throw Damage(kWrongChecksum);
        if (state != Z_OK && state != Z_STREAM_END && state != Z_BUF_ERROR)
            throw Damage(std::string("the file is damaged: ") + (stream_.msg ? stream_.msg : "zlib refuses it"));
        return state == Z_STREAM_END;
    }

private:
    z_stream stream_{};
};

class XzMember final : public Member {
public:
    XzMember() {
        if (lzma_stream_decoder(&stream_, kMostDictionary, 0) != LZMA_OK) throw std::bad_alloc();
    }
    ~XzMember() override { lzma_end(&stream_); }

    bool step(Window& w) override {
        const auto state = runStep(stream_, w, [](lzma_stream* stream) { return lzma_code(stream, LZMA_RUN); });
        if (state == LZMA_MEM_ERROR) throw std::bad_alloc();
        if (state == LZMA_MEMLIMIT_ERROR) throw Damage("it takes too much memory to inflate");
        if (state == LZMA_OPTIONS_ERROR) throw Damage("it needs a newer xz than this program has");
        if (state != LZMA_OK && state != LZMA_STREAM_END && state != LZMA_BUF_ERROR)
            throw Damage("the file is damaged, or its checksum is wrong");
        return state == LZMA_STREAM_END;
    }

private:
    lzma_stream stream_ = LZMA_STREAM_INIT;
};

class Bzip2Member final : public Member {
public:
    Bzip2Member() {
        if (BZ2_bzDecompressInit(&stream_, 0, 0) != BZ_OK) throw std::bad_alloc();
    }
    ~Bzip2Member() override { BZ2_bzDecompressEnd(&stream_); }

    bool step(Window& w) override {
        const int state = runStep(stream_, w, BZ2_bzDecompress);
        if (state == BZ_MEM_ERROR) throw std::bad_alloc();
        if (state != BZ_OK && state != BZ_STREAM_END) throw Damage("the file is damaged, or its checksum is wrong");
        return state == BZ_STREAM_END;
    }

private:
    bz_stream stream_{};
};

class ZstdMember final : public Member {
public:
    ZstdMember() : stream_(ZSTD_createDStream(), ZSTD_freeDStream) {
        if (!stream_) throw std::bad_alloc();
    }

    bool step(Window& w) override {
        ZSTD_inBuffer in{w.in, w.inLeft, 0};
        ZSTD_outBuffer out{w.out, w.outLeft, 0};
        const std::size_t state = ZSTD_decompressStream(stream_.get(), &out, &in);
        w = {w.in + in.pos, w.inLeft - in.pos, w.out + out.pos, w.outLeft - out.pos};
        if (ZSTD_isError(state)) throw Damage(std::string("the file is damaged: ") + ZSTD_getErrorName(state));
        return state == 0;
    }

private:
    std::unique_ptr<ZSTD_DStream, std::size_t (*)(ZSTD_DStream*)> stream_;
};

std::unique_ptr<Member> makeMember(std::string_view compression) {
    if (compression == "gzip") return std::make_unique<GzipMember>();
    if (compression == "xz") return std::make_unique<XzMember>();
    if (compression == "bzip2") return std::make_unique<Bzip2Member>();
    return std::make_unique<ZstdMember>();
}

/// Inflates the member at the front of the bytes, and removes it.
/// @param whole  bytes of the file, for the ratio @param out  output bytes so far; updated
void inflateMember(Member& member, std::string_view& bytes, std::size_t whole, std::size_t maxBytes, std::uint64_t& out,
                   const std::function<void(std::string_view)>& take) {
    const auto part = std::make_unique<char[]>(kChunk);
    for (bool ended = false; !ended;) {
        const std::size_t input = std::min(bytes.size(), kMostInput);
        Window window{bytes.data(), input, part.get(), kChunk};
        ended = member.step(window);
        bytes.remove_prefix(input - window.inLeft);
        const std::size_t size = kChunk - window.outLeft;
        out += size;
        if (out > maxBytes)
            throw Damage("it inflates to more than the limit of " + std::to_string(maxBytes) + " bytes");
        if (out > kFreeOfRatio && out / kMaxRatio > whole - bytes.size())
            throw Damage("it inflates more than " + std::to_string(kMaxRatio) + "-fold, which no structure file does");
        if (size > 0) take({part.get(), size});
        if (!ended && size == 0 && window.inLeft == input) throw Damage("the file is truncated");
    }
}

}  // namespace

std::string_view detectCompression(std::string_view bytes) {
    using std::string_view_literals::operator""sv;
    const auto begins = [&](std::string_view mark) { return bytes.substr(0, mark.size()) == mark; };
    if (begins("\x1f\x8b")) return "gzip";
    if (begins("\xfd\x37zXZ\0"sv)) return "xz";
    if (begins("BZh") && bytes.size() > 3 && bytes[3] >= '1' && bytes[3] <= '9') return "bzip2";
    if (begins("\x28\xb5\x2f\xfd")) return "zstd";
    return {};
}

void decompress(const std::string& name, std::string_view bytes, std::size_t maxBytes,
                const std::function<void(std::string_view)>& take) {
    const std::string_view compression = detectCompression(bytes);
    const std::size_t whole = bytes.size();
    std::uint64_t out = 0;
    try {
        do inflateMember(*makeMember(compression), bytes, whole, maxBytes, out, take);
        while (detectCompression(bytes) == compression);
    } catch (const Damage& damage) {
        throw Error("cannot inflate " + std::string(compression) + " file", name, damage.what());
    }
}

std::string decompress(const std::string& name, std::string_view bytes, std::size_t maxBytes) {
    std::string out;
    decompress(name, bytes, maxBytes, [&](std::string_view part) {
        if (out.size() + part.size() > out.capacity()) out.reserve(std::min(2 * out.size(), maxBytes) + part.size());
        out.append(part);
    });
    return out;
}

}  // namespace nacre
