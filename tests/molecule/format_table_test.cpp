// Lists that have to name every format.

#include "engine/molecule/formats/format_table.h"

#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "tests/molecule/text_file.h"

namespace nacre {
namespace {

std::string sourceFile(const std::string& path) { return test::readText(NACRE_SOURCE_DIR "/" + path); }

std::vector<std::string> splitAllWords(std::string_view list) {
    std::istringstream words{std::string(list)};
    return {std::istream_iterator<std::string>(words), {}};
}

TEST(FormatTable, HasARowForEveryFormat) {
    std::set<std::string> endings;
    std::size_t all = 0;
    for (const FormatRow& row : formatRows()) {
        EXPECT_EQ(formatFromName(row.name), row.format);
        EXPECT_EQ(formatName(row.format), row.name);
        EXPECT_NE(row.read != nullptr, row.readTables != nullptr) << row.name;
        for (const std::string& ending : splitAllWords(row.endings)) ++all, endings.insert(ending);
    }
    EXPECT_EQ(endings.size(), all) << "an ending of two formats";
    for (const char* none : {"cif", ""}) EXPECT_FALSE(formatFromName(none)) << none;
    const std::string header = sourceFile("engine/molecule/read.h");
    const std::string list = header.substr(header.find("enum class Format {"));
    EXPECT_EQ(std::count(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(list.find('}')), ',') + 1,
              static_cast<std::ptrdiff_t>(formatRows().size()));
}

TEST(FormatTable, IsFollowedByEveryList) {
    const std::string documents = sourceFile("app/apple/documents.cmake"), readme = sourceFile("README.md"),
                      android = sourceFile("app/android/src/main/AndroidManifest.xml");
    for (const FormatRow& row : formatRows()) {
        // On phones mmJSON goes by the ending of JSON, which is the systems' own, and there is no HDF5.
        const std::vector<std::string> endings = splitAllWords(row.endings);
        const bool elsewhere = row.format == Format::mmjson || row.format == Format::h5md;
        EXPECT_TRUE(elsewhere || android.find("\\\\." + endings.front() + "\"") != std::string::npos) << row.name;
        for (const std::string& ending : endings) {
            const bool named = documents.find(":" + ending) != std::string::npos ||
                               documents.find("," + ending) != std::string::npos || ending == "json";
            EXPECT_TRUE(named) << ending;
        }
        EXPECT_NE(readme.find(row.title.substr(0, row.title.find('/'))), std::string::npos) << row.title;
    }
}

}  // namespace
}  // namespace nacre
