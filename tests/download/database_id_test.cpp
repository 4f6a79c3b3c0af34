#include "app/download/database_id.h"

#include <gtest/gtest.h>

#include <set>

#include "engine/error.h"

namespace nacre::app {
namespace {

Environment noEnvironment() {
    return [](const char*) { return std::string(); };
}

std::string parseId(const std::string& input) {
    const auto id = parseDatabaseId(input);
    return id ? id->id : "(a file)";
}

TEST(DatabaseId, FilesAreNone) {
    for (const char* name : {"1bna.pdb", "-", "sample:dna", "C:pdb", "dir/pdb:1bna", "pdbx:1bna", ":1bna", "pdb"})
        EXPECT_FALSE(parseDatabaseId(name)) << name;
}

TEST(DatabaseId, ThoseOfThePdb) {
    EXPECT_EQ(parseId("pdb:1BNA"), "1bna");
    EXPECT_EQ(parseId("PDB:4hhb"), "4hhb");
    EXPECT_EQ(parseId("pdb:PDB_00001bna"), "1bna");
    EXPECT_EQ(parseId("pdb:pdb_1abcdefg"), "pdb_1abcdefg");
    EXPECT_EQ(parseId("pdb:pdb_0000abcd"), "pdb_0000abcd");
    for (const char* bad : {"pdb:", "pdb:1bn", "pdb:1bnaa", "pdb:abcd", "pdb:1b/a", "pdb:1b a", "pdb:1b.a", "pdb:../x",
                            "pdb:pdb_1bna", "pdb:pdb_1bna/../", "pdb:1bn\xc3", "pdb:1bna\n"})
        EXPECT_THROW(parseDatabaseId(bad), Error) << bad;
}

TEST(DatabaseId, AccessionsOfUniprot) {
    // Examples of each row of UniProt's table of accession formats.
    for (const char* good : {"A2BC19", "P12345", "A0A023GPI8", "O55743", "Q9H0H5", "a0a023gpi8"})
        EXPECT_NO_THROW(parseDatabaseId(std::string("afdb:") + good)) << good;
    EXPECT_EQ(parseId("afdb:p69905"), "P69905");
    for (const char* bad : {"", "P6990", "P699055", "P6990A", "1A2345", "P1234567890", "A2BCD9X", "PA2345", "P69905-2",
                            "A0A023GPI", "P123456789", "../../", "P6990%"})
        EXPECT_THROW(parseDatabaseId(std::string("afdb:") + bad), Error) << bad;
}

TEST(DatabaseId, NumbersAndNamesOfPubchem) {
    EXPECT_EQ(parseId("pubchem:2244"), "2244");
    EXPECT_EQ(parseId("pubchem:vitamin C"), "vitamin C");
    for (const std::string& bad : {std::string("pubchem:"), std::string("pubchem:0"), std::string("pubchem:012"),
                                   std::string("pubchem:12345678901"), std::string("pubchem:.."),
                                   std::string("pubchem:a\nb"), "pubchem:" + std::string(301, 'a')})
        EXPECT_THROW(parseDatabaseId(bad), Error) << bad;
}

TEST(Sources, AreTheDocumentedAddresses) {
    const auto urls = [](const char* input) {
        std::vector<std::string> list;
        for (const Source& source : listSources(*parseDatabaseId(input), noEnvironment())) list.push_back(source.url);
        return list;
    };
    using Urls = std::vector<std::string>;
    EXPECT_EQ(urls("pdb:1BNA"),
              (Urls{"https://models.rcsb.org/1bna.bcif.gz", "https://files.rcsb.org/download/1bna.cif.gz"}));
    EXPECT_EQ(urls("pubchem:2244")[0],
              "https://pubchem.ncbi.nlm.nih.gov/rest/pug/compound/cid/2244/record/SDF?record_type=3d");
    EXPECT_EQ(urls("pubchem:2244")[1],
              "https://pubchem.ncbi.nlm.nih.gov/rest/pug/compound/cid/2244/record/SDF?record_type=2d");
    EXPECT_EQ(urls("afdb:P69905")[0], "https://alphafold.ebi.ac.uk/api/prediction/P69905");
}

TEST(Sources, NamesAreEscaped) {
    const auto sources = listSources(*parseDatabaseId("pubchem:a/b?c=#%& \xc3\xa4.."), noEnvironment());
    EXPECT_NE(sources[0].url.find("/name/a%2Fb%3Fc%3D%23%25%26%20%C3%A4../record/"), std::string::npos)
        << sources[0].url;
}

TEST(Sources, FileNamesAreHarmlessAndTellStructuresApart) {
    std::set<std::string> names;
    for (const char* input : {"pdb:1bna", "pdb:pdb_1abcdefg", "pubchem:2244", "pubchem:../../etc/passwd",
                              "pubchem:A long name (with) everything: [1,2-b]", "pubchem:b", "afdb:P69905"})
        for (const Source& source : listSources(*parseDatabaseId(input), noEnvironment())) {
            EXPECT_TRUE(names.insert(source.cacheName).second) << source.cacheName;
            EXPECT_LE(source.cacheName.size(), 100u);
            EXPECT_EQ(source.cacheName.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-_."), std::string::npos)
                << source.cacheName;
            EXPECT_NE(source.cacheName[0], '.');
        }
    EXPECT_EQ(listSources(*parseDatabaseId("pubchem:Aspirin"), noEnvironment())[0].cacheName,
              listSources(*parseDatabaseId("pubchem:aspirin"), noEnvironment())[0].cacheName);
}

TEST(Sources, TheEnvironmentNamesOtherServers) {
    const auto environment = [](const char* name) -> std::string {
        return std::string(name) == "NACRE_PDB_URL" ? "http://localhost:8000/pdb//" : "";
    };
    EXPECT_EQ(listSources(*parseDatabaseId("pdb:1bna"), environment)[1].url, "http://localhost:8000/pdb/1bna.cif.gz");
    for (const char* bad : {"file:///etc", "ftp://host/", "localhost:8000", "-o"})
        EXPECT_THROW(listSources(*parseDatabaseId("pdb:1bna"), [&](const char*) { return std::string(bad); }), Error);
}

}  // namespace
}  // namespace nacre::app
