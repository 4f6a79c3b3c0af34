#pragma once
// Writes a small GSD file.

#include <cstdint>
#include <initializer_list>
#include <string>

namespace nacre::test {

/// Two frames of three beads, as the format's page describes them: version 1 has names of 64 bytes each, version 2 one
/// after the other.
inline std::string gsdBytes(bool packed) {
    std::string body, index, names;
    std::uint16_t count = 0;
    const auto number = [](auto value) { return std::string(reinterpret_cast<const char*>(&value), sizeof value); };
    const auto chunk = [&](std::uint64_t frame, std::uint16_t id, std::uint64_t rows, std::uint32_t columns,
                           std::uint8_t type, const std::string& bytes) {
        index += number(frame) + number(rows) + number(std::int64_t{256} + static_cast<std::int64_t>(body.size())) +
                 number(columns) + number(id) + number(type) + number(std::uint8_t{0});
        body += bytes;
    };
    const auto named = [&](const std::string& name) {
        names += name + (packed ? std::string(1, '\0') : std::string(64 - name.size(), '\0'));
        return count++;
    };
    const auto floats = [&](std::initializer_list<float> values) {
        std::string bytes;
        for (const float value : values) bytes += number(value);
        return bytes;
    };
    const auto wholes = [&](std::initializer_list<std::uint32_t> values) {
        std::string bytes;
        for (const std::uint32_t value : values) bytes += number(value);
        return bytes;
    };
    const std::uint16_t positions = named("particles/position");
    chunk(0, positions, 3, 3, 9, floats({0, 0, 0, 1, 0, 0, 2, 0, 0}));
    chunk(0, named("particles/types"), 2, 2, 5, std::string("B\0C\0", 4));
    chunk(0, named("particles/typeid"), 3, 1, 3, wholes({0, 1, 0}));
    chunk(0, named("particles/diameter"), 3, 1, 9, floats({1, 2, 1}));
    chunk(0, named("bonds/group"), 2, 2, packed ? 7 : 3, wholes({0, 1, 1, 2}));  // signed or unsigned
    chunk(0, named("configuration/box"), 6, 1, 9, floats({10, 10, 10, 0.1f, 0, 0}));
    chunk(1, positions, 3, 3, 9, floats({0, 0, 1, 1, 0, 1, 2, 0, 1}));
    const std::uint64_t entries = index.size() / 32;
    names += std::string((64 - names.size() % 64) % 64, '\0');
    std::string header = number(std::uint64_t{0x65DF65DF65DF65DF}) + number(std::uint64_t{256 + body.size()}) +
                         number(entries) + number(std::uint64_t{256 + body.size() + index.size()}) +
                         number(std::uint64_t{names.size() / 64}) + number(std::uint32_t{0x10004}) +
                         number(std::uint32_t{packed ? 0x20000u : 0x10000u});
    header.resize(256);
    return header + body + index + names;
}

}  // namespace nacre::test
