#include "engine/molecule/formats/inflate.h"

#include <zlib.h>

#include <algorithm>
#include <limits>

#include "engine/error.h"

namespace nacre {

namespace {

constexpr std::size_t kFreeOfRatio = std::size_t{64} << 20;
constexpr std::size_t kMaxRatio = 100;
constexpr std::size_t kChunk = std::size_t{256} << 10;

class Inflater {
public:
    Inflater(const std::string& name, std::string_view bytes, std::size_t maxBytes)
        : name_(name), bytes_(bytes), maxBytes_(maxBytes) {
        constexpr int kGzipOnly = 16 + MAX_WBITS;
        if (inflateInit2(&stream_, kGzipOnly) != Z_OK) fail("zlib could not start");
    }
    ~Inflater() { inflateEnd(&stream_); }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;

    std::string run() {
        std::string out;
        do {
            inflateReset(&stream_);
            member(out);
        } while (isGzip(bytes_.substr(position_)));
        return out;
    }

private:
    [[noreturn]] void fail(const std::string& why) const { throw Error("cannot inflate gzip file", name_, why); }

    void member(std::string& out) {
        int state = Z_OK;
        while (state != Z_STREAM_END) {
            const std::size_t input =
                std::min<std::size_t>(bytes_.size() - position_, std::numeric_limits<uInt>::max());
            stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes_.data() + position_));
            stream_.avail_in = static_cast<uInt>(input);
            const std::size_t size = out.size();
            out.resize(size + kChunk);
            stream_.next_out = reinterpret_cast<Bytef*>(out.data() + size);
            stream_.avail_out = static_cast<uInt>(kChunk);
            state = inflate(&stream_, Z_NO_FLUSH);
            position_ += input - stream_.avail_in;
            out.resize(size + kChunk - stream_.avail_out);
            judge(state, out.size());
        }
    }

    void judge(int state, std::size_t inflated) const {
        if (inflated > maxBytes_) fail("it inflates to more than the limit of " + std::to_string(maxBytes_) + " bytes");
        if (inflated > kFreeOfRatio && inflated / kMaxRatio > position_)
            fail("it inflates more than " + std::to_string(kMaxRatio) + "-fold, which no structure file does");
        if (state == Z_BUF_ERROR) fail("the file is truncated");
        if (state == Z_DATA_ERROR && stream_.msg && std::string_view(stream_.msg) == "incorrect data check")
            fail("wrong checksum (CRC): the file is damaged");
        if (state != Z_OK && state != Z_STREAM_END)
            fail(std::string("the file is damaged: ") + (stream_.msg ? stream_.msg : "zlib refuses it"));
    }

    const std::string& name_;
    std::string_view bytes_;
    std::size_t maxBytes_;
    std::size_t position_ = 0;
    z_stream stream_{};
};

}  // namespace

bool isGzip(std::string_view bytes) { return bytes.size() >= 2 && bytes.substr(0, 2) == "\x1f\x8b"; }

std::string inflateGzip(const std::string& name, std::string_view bytes, std::size_t maxBytes) {
    return Inflater(name, bytes, maxBytes).run();
}

}  // namespace nacre
