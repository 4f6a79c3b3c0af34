#include "engine/molecule/trajectory/hdf5_heaps.h"

#include <algorithm>

namespace nacre {
namespace {

constexpr std::string_view kMark("GCOL\1\0\0\0", 8);
constexpr std::size_t kHead = 16;  // of a heap, and of each of its objects: number, uses, 4 bytes, size

std::uint64_t numberIn(std::string_view text, std::size_t at, std::size_t count) {
    std::uint64_t value = 0;
    while (count-- > 0) value = value << 8 | static_cast<unsigned char>(text[at + count]);
    return value;
}

/// @param headAt  bytes at a position, fewer than kHead if there are none
/// @param steps  of all heaps: overlapping ones would be walked repeatedly
template <typename HeadAt, typename Visit>
void visitObjects(std::uint64_t heap, std::uint64_t fileBytes, std::uint64_t& steps, const HeadAt& headAt,
                  const Visit& visit) {
    const auto first = headAt(heap);
    if (first.size() < kHead || !first.starts_with(kMark)) return;
    const std::uint64_t whole = std::min<std::uint64_t>(numberIn(first, 8, 8), INT64_MAX);
    for (std::uint64_t at = kHead; at <= whole && whole - at >= kHead;) {
        const auto head = headAt(heap + at);
        if (head.size() < kHead) return;
        const std::uint64_t size = numberIn(head, 8, 8);
        const auto number = static_cast<std::uint16_t>(numberIn(head, 0, 2));
        const bool isFree = number == 0;
        if (++steps > fileBytes / kHead || size > whole - at || (isFree && size == 0))
            throw Hdf5Fault("it is damaged: a heap that does not end");
        if (!isFree) visit(number, heap + at + kHead, size);
        at += isFree ? size : kHead + (size + 7) / 8 * 8;
    }
}

}  // namespace

void Hdf5Heaps::check(std::string_view bytes) {
    std::uint64_t steps = 0;
    const auto headAt = [&](std::uint64_t at) {
        return at < bytes.size() ? bytes.substr(static_cast<std::size_t>(at), kHead) : std::string_view();
    };
    for (std::size_t heap = 0; (heap = bytes.find(kMark, heap)) != std::string_view::npos; ++heap)
        visitObjects(heap, bytes.size(), steps, headAt, [](std::uint16_t, std::uint64_t, std::uint64_t) {});
}

std::string Hdf5Heaps::text(std::string_view reference, std::size_t most) {
    const std::uint64_t length = numberIn(reference, 0, 4), heap = numberIn(reference, 4, 8),
                        number = numberIn(reference, 12, 4);
    if (length == 0 || length > most || number > UINT16_MAX || heap > fileBytes_ || base_ > fileBytes_) return {};
    const Objects& objects = readObjects(base_ + heap);
    const auto found = objects.find(static_cast<std::uint16_t>(number));
    if (found == objects.end() || found->second.size < length) return {};
    const std::string text = read_(found->second.at, static_cast<std::size_t>(length));
    return text.substr(0, text.find('\0'));
}

const Hdf5Heaps::Objects& Hdf5Heaps::readObjects(std::uint64_t heap) {
    const auto [known, added] = known_.try_emplace(heap);
    Objects& objects = known->second;  // a lambda cannot capture `known` in Clang 14
    if (added)
        visitObjects(
            heap, fileBytes_, steps_, [&](std::uint64_t at) { return read_(at, kHead); },
            [&](std::uint16_t number, std::uint64_t at, std::uint64_t size) {
                objects[number] = {at, size};
            });
    return objects;
}

}  // namespace nacre
