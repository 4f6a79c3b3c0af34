#include "engine/molecule/formats/packed_integers.h"

#include <algorithm>

namespace nacre {

namespace {

template <typename Wire>
class Bytes final : public Integers {
public:
    Bytes(std::string_view bytes, ByteOrder order) : bytes_(bytes), order_(order) {}

private:
    std::size_t fill(std::int32_t* values, std::size_t most) override {
        const std::size_t count = std::min(most, bytes_.size() / sizeof(Wire));
        const auto* data = reinterpret_cast<const unsigned char*>(bytes_.data());
        for (std::size_t i = 0; i < count; ++i) {
            std::uint32_t bits = 0;
            for (std::size_t k = 0; k < sizeof(Wire); ++k) {
                const std::size_t byte = order_ == ByteOrder::little ? k : sizeof(Wire) - 1 - k;
                bits |= std::uint32_t{data[i * sizeof(Wire) + byte]} << 8 * k;
            }
            // NOLINTNEXTLINE(bugprone-signed-char-misuse): numbers
            values[i] = static_cast<std::int32_t>(static_cast<Wire>(bits));
            if (static_cast<Wire>(-1) > 0 && values[i] < 0) throw PackedFault("a value exceeds 2147483647");
        }
        bytes_.remove_prefix(count * sizeof(Wire));
        return count;
    }

    std::string_view bytes_;
    ByteOrder order_;
};

class Extremes final : public Integers {
public:
    Extremes(IntegersPointer packed, IntegerType type) : packed_(std::move(packed)) {
        const auto bits = static_cast<unsigned>(8 * type.bytes);
        high_ = type.isSigned ? (1 << (bits - 1)) - 1 : (1 << bits) - 1;
        low_ = type.isSigned ? -high_ - 1 : -1;  // -1: never occurs among unsigned values
    }

private:
    std::size_t fill(std::int32_t* values, std::size_t most) override {
        std::size_t count = 0;
        for (std::int32_t part = 0; count < most && packed_->next(part);) {
            sum_ += static_cast<std::uint32_t>(part);
            open_ = part == high_ || part == low_;
            if (open_) continue;
            values[count++] = static_cast<std::int32_t>(sum_);
            sum_ = 0;
        }
        if (count == 0 && open_) throw PackedFault("its last value is cut short");
        return count;
    }

    IntegersPointer packed_;
    std::int32_t high_, low_;
    std::uint32_t sum_ = 0;
    bool open_ = false;
};

class Runs final : public Integers {
public:
    explicit Runs(IntegersPointer runs) : runs_(std::move(runs)) {}

private:
    std::size_t fill(std::int32_t* values, std::size_t most) override {
        while (left_ == 0) {
            if (!runs_->next(value_)) return 0;
            if (!runs_->next(left_) || left_ < 0) throw PackedFault("a run has no length, or a negative one");
        }
        const std::size_t count = std::min(most, static_cast<std::size_t>(left_));
        std::fill_n(values, count, value_);
        left_ -= static_cast<std::int32_t>(count);
        return count;
    }

    IntegersPointer runs_;
    std::int32_t value_ = 0, left_ = 0;
};

class Sums final : public Integers {
public:
    Sums(IntegersPointer deltas, std::int32_t origin)
        : deltas_(std::move(deltas)), sum_(static_cast<std::uint32_t>(origin)) {}

private:
    std::size_t fill(std::int32_t* values, std::size_t most) override {
        std::size_t count = 0;
        for (std::int32_t delta = 0; count < most && deltas_->next(delta); ++count) {
            sum_ += static_cast<std::uint32_t>(delta);
            values[count] = static_cast<std::int32_t>(sum_);
        }
        return count;
    }

    IntegersPointer deltas_;
    std::uint32_t sum_;
};

class Counted final : public Integers {
public:
    Counted(IntegersPointer values, std::size_t size) : values_(std::move(values)), size_(size) {}

private:
    std::size_t fill(std::int32_t* values, std::size_t most) override {
        std::size_t count = 0;
        while (count < most && values_->next(values[count])) ++count;
        seen_ += count;
        if (seen_ > size_ || (count == 0 && seen_ < size_))
            throw PackedFault("it does not have " + std::to_string(size_) + " values as stated");
        return count;
    }

    IntegersPointer values_;
    std::size_t size_, seen_ = 0;
};

}  // namespace

IntegersPointer integersFromBytes(std::string_view bytes, IntegerType type, ByteOrder order) {
    if (bytes.size() % type.bytes != 0) throw PackedFault("its size is not a whole number of values");
    const auto make = [&](auto wire) -> IntegersPointer {
        return std::make_unique<Bytes<decltype(wire)>>(bytes, order);
    };
    if (type.bytes == 1) return type.isSigned ? make(std::int8_t{}) : make(std::uint8_t{});
    if (type.bytes == 2) return type.isSigned ? make(std::int16_t{}) : make(std::uint16_t{});
    return type.isSigned ? make(std::int32_t{}) : make(std::uint32_t{});
}

IntegersPointer unpackExtremes(IntegersPointer packed, IntegerType type) {
    return std::make_unique<Extremes>(std::move(packed), type);
}

IntegersPointer expandRuns(IntegersPointer runs) { return std::make_unique<Runs>(std::move(runs)); }

IntegersPointer sumDeltas(IntegersPointer values, std::int32_t origin) {
    return std::make_unique<Sums>(std::move(values), origin);
}

IntegersPointer exactly(IntegersPointer values, std::size_t size) {
    return std::make_unique<Counted>(std::move(values), size);
}

}  // namespace nacre
