#include "engine/occlusion/cache.h"

#include <xxhash.h>

#include <bit>
#include <cstdio>
#include <cstring>
#include <memory>

#include "engine/occlusion/bounced_light.h"
#include "engine/scene/build/translucency.h"

namespace nacre {
namespace {

constexpr std::string_view kPrefix = "occlusion-";  // of file names

/// File layout: this header, the atlas, one bit per sphere, and a hash of the file name and everything before it.
struct Header {
    char magic[8] = {'N', 'A', 'C', 'R', 'E', 'O', 'C', 'C'};
    std::uint32_t version = kOcclusionVersion;
    std::uint32_t sphereEdge = 0, around = 0, along = 0, width = 0, height = 0, sphereRows = 0, sphereCount = 0,
                  cylinderCount = 0;
    std::uint32_t cylinderRows = 0, vertexCount = 0;
    std::uint32_t bounced = 0;
    std::uint64_t openTexels = 0;
};
static_assert(sizeof(Header) == 64 && std::has_unique_object_representations_v<Header>);

class Hash {
public:
    Hash() : state_(XXH3_createState()) {
        if (!state_) throw std::bad_alloc();
        XXH3_128bits_reset(state_.get());
    }
    Hash& add(const void* bytes, std::size_t size) {
        XXH3_128bits_update(state_.get(), bytes, size);
        return *this;
    }
    template <typename T>
    Hash& add(const T& value) {
        static_assert(std::has_unique_object_representations_v<T>);
        return add(&value, sizeof value);
    }
    /// 16 bytes, in the order of printed XXH128 hashes.
    XXH128_canonical_t result() const {
        XXH128_canonical_t canonical;
        XXH128_canonicalFromHash(&canonical, XXH3_128bits_digest(state_.get()));
        return canonical;
    }

private:
    struct Free {
        void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
    };
    std::unique_ptr<XXH3_state_t, Free> state_;
};

std::string_view asBytes(const void* data, std::size_t size) { return {static_cast<const char*>(data), size}; }

std::vector<std::uint8_t> packed(const std::vector<bool>& bits) {
    std::vector<std::uint8_t> bytes((bits.size() + 7) / 8);
    for (std::size_t i = 0; i < bits.size(); ++i)
        if (bits[i]) bytes[i / 8] = static_cast<std::uint8_t>(bytes[i / 8] | 1u << i % 8);
    return bytes;
}

/// Positions of the runs of an assembly.
void addCopies(Hash& hash, const Copies& copies) {
    hash.add(std::uint64_t{copies.transforms.size()});
    hash.add(copies.transforms.data(), copies.transforms.size() * sizeof(glm::dmat4x3));
    for (const std::vector<std::uint32_t>& list : copies.lists)
        hash.add(std::uint64_t{list.size()}).add(list.data(), list.size() * sizeof(std::uint32_t));
    for (const auto* runs : {&copies.spheres, &copies.cylinders, &copies.triangles})
        for (const PrimitiveRun& run : *runs) hash.add(run.first).add(run.count).add(run.list);
}

std::string fileName(const Hash& hash) {
    const XXH128_canonical_t result = hash.result();
    std::string name(kPrefix);
    for (const unsigned char byte : result.digest) {
        char hex[3];
        std::snprintf(hex, sizeof hex, "%02x", byte);
        name += hex;
    }
    return name;
}

XXH128_canonical_t checksum(const std::string& name, std::string_view content) {
    return Hash().add(name.data(), name.size()).add(content.data(), content.size()).result();
}

}  // namespace

DiskCache occlusionCache(const std::string& folder) { return {folder, kOcclusionCacheBytes, {std::string(kPrefix)}}; }

std::string occlusionCacheName(const Representation& representation, std::string_view how) {
    Hash hash;
    hash.add(kOcclusionVersion).add(std::uint64_t{how.size()}).add(how.data(), how.size());
    hash.add(std::uint64_t{representation.spheres.size()});
    hash.add(representation.spheres.data(), representation.spheres.size() * sizeof(Sphere));
    if (!representation.ellipsoids.empty())
        hash.add(representation.ellipsoids.data(), representation.ellipsoids.size() * sizeof(EllipsoidRows));
    hash.add(representation.cylinders.data(), representation.cylinders.size() * sizeof(Cylinder));
    hash.add(std::uint64_t{representation.triangles.size()}).add(std::uint64_t{representation.meshVertices.size()});
    for (const Triangle& t : representation.triangles)
        hash.add(t.a).add(t.b).add(t.c).add(std::bit_cast<std::uint32_t>(t.step()));
    for (const MeshVertex& v : representation.meshVertices) hash.add(v.xz).add(v.yz).add(v.normal);
    const TranslucentParts translucent = translucentParts(representation);
    for (const TranslucentRuns* runs : {&translucent.spheres, &translucent.cylinders, &translucent.triangles}) {
        hash.add(std::uint64_t{runs->size()});
        for (const TranslucentRun& run : *runs) hash.add(run.first).add(run.count);
    }
    hash.add(std::bit_cast<std::uint64_t>(representation.radius));
    addCopies(hash, representation.copies);
    for (const auto* runs :
         {&representation.sphereModels, &representation.cylinderModels, &representation.triangleModels})
        for (const ModelRun& run : *runs) hash.add(run.first).add(run.count).add(run.model);
    return fileName(hash);
}

std::string bouncedCacheName(const Representation& r, std::string_view name) {
    Hash hash;
    hash.add(kBouncedVersion).add(name.data(), name.size());
    for (const SphereLook& look : r.sphereLooks) hash.add(look.color);
    for (const CylinderLook& look : r.cylinderLooks) hash.add(look.colorA).add(look.colorB);
    for (const MeshVertex& v : r.meshVertices) hash.add(r.meshLooks[v.look].color);
    return fileName(hash);
}

std::optional<FinishedOcclusion> readOcclusion(const DiskCache& cache, const std::string& name,
                                               const Representation& representation, std::uint32_t mostSide) {
    const std::optional<std::string> file = cache.read(name);
    Header header;
    constexpr std::size_t kLeast = sizeof(Header) + sizeof(XXH128_canonical_t);
    if (!file || file->size() < kLeast) return std::nullopt;
    const std::string_view content = std::string_view(*file).substr(0, file->size() - sizeof(XXH128_canonical_t));
    const XXH128_canonical_t expected = checksum(name, content);
    if (std::memcmp(expected.digest, file->data() + content.size(), sizeof expected.digest) != 0) return std::nullopt;
    std::memcpy(&header, content.data(), sizeof header);

    const Header fresh;
    if (std::memcmp(header.magic, fresh.magic, sizeof fresh.magic) != 0 || header.version != kOcclusionVersion ||
        header.sphereCount != representation.spheres.size() ||
        header.cylinderCount != representation.cylinders.size() ||
        header.vertexCount != representation.meshVertices.size())
        return std::nullopt;
    FinishedOcclusion finished;
    finished.layout = {header.sphereEdge,    header.around,     header.along,        header.width,
                       header.height,        header.sphereRows, header.cylinderRows, header.sphereCount,
                       header.cylinderCount, header.vertexCount};
    const std::uint64_t texels = std::uint64_t{header.width} * header.height * (header.bounced ? kBytesPerBounced : 1);
    const std::uint64_t bits = (std::uint64_t{header.sphereCount} + 7) / 8;
    if (!holdsItsPatches(finished.layout, mostSide) || (header.bounced ? 2u : 1u) * header.height > mostSide ||
        content.size() != sizeof header + texels + bits || header.openTexels > finished.layout.texelCount())
        return std::nullopt;
    const auto* atlas = reinterpret_cast<const std::uint8_t*>(content.data()) + sizeof header;
    finished.atlas.assign(atlas, atlas + texels);
    finished.seenSpheres.resize(header.sphereCount);
    for (std::size_t i = 0; i < finished.seenSpheres.size(); ++i)
        finished.seenSpheres[i] = (atlas[texels + i / 8] >> i % 8 & 1) != 0;
    finished.openTexels = header.openTexels;
    finished.bounced = header.bounced != 0;
    return finished;
}

bool writeOcclusion(const DiskCache& cache, const std::string& name, const FinishedOcclusion& finished) {
    const OcclusionLayout& layout = finished.layout;
    Header header;
    header.sphereEdge = layout.sphereEdge;
    header.around = layout.around;
    header.along = layout.along;
    header.width = layout.width;
    header.height = layout.height;
    header.sphereRows = layout.sphereRows;
    header.sphereCount = layout.sphereCount;
    header.cylinderCount = layout.cylinderCount;
    header.cylinderRows = layout.cylinderRows;
    header.vertexCount = layout.vertexCount;
    header.openTexels = finished.openTexels;
    header.bounced = finished.bounced ? 1 : 0;
    const std::vector<std::uint8_t> seen = packed(finished.seenSpheres);
    std::string content(asBytes(&header, sizeof header));
    content.append(reinterpret_cast<const char*>(finished.atlas.data()), finished.atlas.size());
    content.append(reinterpret_cast<const char*>(seen.data()), seen.size());
    const XXH128_canonical_t sum = checksum(name, content);
    const std::string_view parts[] = {content, asBytes(sum.digest, sizeof sum.digest)};
    return cache.write(name, parts);
}

}  // namespace nacre
