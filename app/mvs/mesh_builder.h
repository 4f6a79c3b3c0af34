#pragma once
// Shared by the readers of mesh files.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "app/mvs/mesh_files.h"
#include "engine/error.h"

namespace nacre::app::mvs {

constexpr std::uint32_t kNoMaterialColor = packedColor(0x808080);

enum class NumberType { int8, uint8, int16, uint16, int32, uint32, float32, float64, int64, uint64 };

inline std::size_t sizeOf(NumberType type) {
    constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8, 8, 8};
    return kSizes[static_cast<std::size_t>(type)];
}

template <typename Value>
double valueAt(const char* bytes, bool little) {
    char copy[sizeof(Value)];
    std::memcpy(copy, bytes, sizeof(Value));
    if (little != (std::endian::native == std::endian::little)) std::reverse(std::begin(copy), std::end(copy));
    Value value;
    std::memcpy(&value, copy, sizeof(Value));
    return static_cast<double>(value);
}

inline double numberAt(const char* bytes, NumberType type, bool little) {
    switch (type) {
        case NumberType::int8:
            return valueAt<std::int8_t>(bytes, little);
        case NumberType::uint8:
            return valueAt<std::uint8_t>(bytes, little);
        case NumberType::int16:
            return valueAt<std::int16_t>(bytes, little);
        case NumberType::uint16:
            return valueAt<std::uint16_t>(bytes, little);
        case NumberType::int32:
            return valueAt<std::int32_t>(bytes, little);
        case NumberType::uint32:
            return valueAt<std::uint32_t>(bytes, little);
        case NumberType::float32:
            return valueAt<float>(bytes, little);
        case NumberType::int64:
            return valueAt<std::int64_t>(bytes, little);
        case NumberType::uint64:
            return valueAt<std::uint64_t>(bytes, little);
        default:
            return valueAt<double>(bytes, little);
    }
}

/// A packed colour from values of 0 to 255.
inline std::uint32_t byteColor(const std::array<double, 3>& rgb) {
    std::uint32_t packed = 0;
    for (const double value : rgb)
        packed = packed << 8 | static_cast<std::uint32_t>(std::lround(value >= 0 ? std::min(value, 255.0) : 0.0));
    return packedColor(packed);
}

/// A mesh that grows within its limits.
class MeshBuilder {
public:
    explicit MeshBuilder(const std::string& name) : name_(name) {
        mesh_.smooth = true;
        mesh_.looks.clear();  // of a mesh in one colour
    }

    [[noreturn]] void refuse(const std::string& place, const std::string& why) const {
        throw Error("cannot read mesh", name_, place + why);
    }
    void addVertex(const std::string& place, const glm::dvec3& at) {
        for (int i = 0; i < 3; ++i)
            if (!(std::abs(at[i]) <= kFarthestPrimitive)) refuse(place, "a vertex needs three numbers within 1e6 Å");
        if (mesh_.positions.size() == kMostMeshVertices)
            refuse("", "it has more than " + std::to_string(kMostMeshVertices) + " vertices");
        mesh_.positions.push_back(at);
    }
    std::size_t vertices() const { return mesh_.positions.size(); }
    const std::vector<std::array<std::uint32_t, 3>>& triangles() const { return mesh_.triangles; }
    /// @param corners  from 0
    void addFace(const std::string& place, const std::vector<std::int64_t>& corners) {
        if (corners.size() < 3) refuse(place, "a face has fewer than three corners");
        for (const std::int64_t corner : corners)
            if (corner < 0 || corner >= static_cast<std::int64_t>(vertices()))
                refuse(place, "a face names a vertex that is not there");
        if (mesh_.triangles.size() + corners.size() - 2 > kMostMeshTriangles)
            refuse("", "it has more than " + std::to_string(kMostMeshTriangles) + " triangles");
        const auto corner = [&](std::size_t i) { return static_cast<std::uint32_t>(corners[i]); };
        for (std::size_t i = 2; i < corners.size(); ++i)
            mesh_.triangles.push_back({corner(0), corner(i - 1), corner(i)});
    }
    Primitives::Mesh finish() {
        if (mesh_.triangles.empty()) refuse("", "it has no faces");
        return std::move(mesh_);
    }
    /// @param colors  of vertices, packed
    Primitives::Mesh finishBlended(const std::vector<std::uint32_t>& colors) {
        mesh_.blends = true;
        return finishColored(colors);
    }
    /// @param colors  of triangles, packed
    Primitives::Mesh finishColored(const std::vector<std::uint32_t>& colors) {
        for (const std::uint32_t color : colors) mesh_.looks.push_back({.color = color});
        return finish();
    }

private:
    const std::string& name_;
    Primitives::Mesh mesh_;
};

}  // namespace nacre::app::mvs
