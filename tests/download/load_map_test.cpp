// Maps from databases, by a server on this machine.

#include "app/download/load_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <cstring>

#include "app/drawing/map_layers.h"
#include "app/input/map_input.h"
#include "engine/error.h"
#include "tests/molecule/gzip_bytes.h"
#include "tests/support/error_text.h"
#include "tests/support/structure_server.h"

namespace nacre::app {
namespace {

using test::StructureServer;
using test::TemporaryFolder;

/// A CCP4 map of 4 by 4 by 4 nodes, 1 Å apart, whose values are those of a ramp from 0 to 63.
std::string rampMap() {
    std::array<std::int32_t, 256> header{};
    for (const std::size_t word : {0u, 1u, 2u, 7u, 8u, 9u}) header[word] = 4;
    header[3] = 2;
    for (std::size_t i = 0; i < 3; ++i) {
        header[10 + i] = std::bit_cast<std::int32_t>(4.0f);
        header[13 + i] = std::bit_cast<std::int32_t>(90.0f);
        header[16 + i] = static_cast<std::int32_t>(i + 1);
    }
    header[20] = std::bit_cast<std::int32_t>(63.0f);
    header[21] = std::bit_cast<std::int32_t>(31.5f);
    header[22] = 1;
    std::memcpy(&header[52], "MAP ", 4);
    header[53] = 0x4144;
    header[54] = std::bit_cast<std::int32_t>(18.5f);
    std::array<float, 64> values;
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i);
    return std::string(reinterpret_cast<const char*>(header.data()), sizeof header) +
           std::string(reinterpret_cast<const char*>(values.data()), sizeof values);
}

class LoadMaps : public testing::Test {
protected:
    static void SetUpTestSuite() {
        server_ = new StructureServer;
        server_->serve("EMD-9001_map_emd_9001.map.gz", test::gzipBytes(rampMap()));
        server_->serve("EMD-9002_map_emd_9002.map.gz", test::gzipBytes(rampMap()));
        server_->serve("entry_map_EMD-9001", R"({"map": {"contour_list": {"contour": [
            {"level": 7, "primary": false}, {"level": 42.5, "primary": true}]}}})");
        server_->serve("9xyz.ccp4", rampMap());
        server_->serve("9xyz_diff.ccp4", rampMap());
        server_->serve("9bad.ccp4", "<html>gone</html>");
        const std::string base = server_->base("ok");
        for (const char* name : {"NACRE_EMDB_URL", "NACRE_EMDB_API_URL", "NACRE_PDB_MAP_URL"})
            setenv(name, base.c_str(), 1);
    }
    static void TearDownTestSuite() {
        for (const char* name : {"NACRE_EMDB_URL", "NACRE_EMDB_API_URL", "NACRE_PDB_MAP_URL"}) unsetenv(name);
        delete server_;
        server_ = nullptr;
    }

    /// A map from its database, by way of the cache on disk.
    std::shared_ptr<const DensityMap> load(const std::string& name) {
        PictureDescription picture;
        picture.input.cache = folder_.path();
        picture.maps.files = {name};
        loadMaps(picture);
        return loadMap(name, {});
    }
    std::size_t requestsFor(const std::string& part) const {
        const auto all = server_->requests();
        return static_cast<std::size_t>(std::count_if(
            all.begin(), all.end(), [&](const std::string& line) { return line.find(part) != std::string::npos; }));
    }

    static StructureServer* server_;
    TemporaryFolder folder_;
};
StructureServer* LoadMaps::server_ = nullptr;

TEST_F(LoadMaps, OfEmdbHaveTheLevelOfTheirDepositors) {
    const auto map = load("emdb:9001");
    EXPECT_EQ(map->size, glm::ivec3(4));
    ASSERT_TRUE(map->depositedLevel);
    EXPECT_EQ(*map->depositedLevel, 42.5) << "the primary contour";
    EXPECT_EQ(contourLevel(*map, {}), 42.5);
    EXPECT_EQ(contourLevel(*map, parseMapLevel("3")), 3);
    EXPECT_EQ(requestsFor("/EMD-9001/map/emd_9001.map.gz"), 1u);
    EXPECT_EQ(requestsFor("/entry/map/EMD-9001"), 1u);
    EXPECT_EQ(load("emdb:9001"), map) << "kept";
    EXPECT_EQ(requestsFor("emd_9001"), 1u);
}

TEST_F(LoadMaps, WithoutADepositorsLevelShowTheHighestHundredth) {
    const auto map = load("emdb:EMD-9002");
    EXPECT_FALSE(map->depositedLevel);
    EXPECT_EQ(contourLevel(*map, {}), contourLevel(*map, parseMapLevel("top1%")));
}

TEST_F(LoadMaps, OfThePdbAreFoundByTheirKind) {
    EXPECT_FALSE(load("pdb-map:9XYZ")->difference);
    EXPECT_TRUE(load("pdb-diff:9xyz")->difference);
    EXPECT_EQ(requestsFor("/9xyz.ccp4"), 1u);
    EXPECT_EQ(requestsFor("/9xyz_diff.ccp4"), 1u);
}

TEST_F(LoadMaps, FailWithOneLine) {
    const auto failure = [&](const std::string& name) -> std::string { return test::errorText([&] { load(name); }); };
    for (const char* name : {"emdb:9999", "pdb-map:9zzz", "pdb-map:9bad", "emdb:12", "pdb-map:12345"}) {
        const std::string text = failure(name);
        const std::string id = std::string(name).substr(std::string(name).find(':') + 1);
        EXPECT_NE(text.find(id), std::string::npos) << name << ": " << text;
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    }
}

}  // namespace
}  // namespace nacre::app
