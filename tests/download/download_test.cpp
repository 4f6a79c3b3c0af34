// The real client against a real server on this machine, which serves well and badly.

#include "app/download/download.h"

#include <gtest/gtest.h>

#include <fstream>

#include "engine/error.h"
#include "engine/molecule/read.h"
#include "tests/molecule/bcif_writer.h"
#include "tests/molecule/gzip_bytes.h"
#include "tests/support/error_text.h"
#include "tests/support/structure_server.h"

namespace nacre::app {
namespace {

namespace fs = std::filesystem;
using test::StructureServer;
using test::TemporaryFolder;

constexpr std::size_t kDnaAtoms = 486;  // of sample:dna

std::string dnaAsBcif() {
    Molecule dna = sampleMolecule("dna");
    dna.subchains = {"A"};
    for (Residue& residue : dna.residues) residue.subchain = 0;
    return test::writeBcif(dna);
}

/// A server that knows 1bna and 3bna (BinaryCIF), 2cif (mmCIF alone), and some compounds.
class Download : public testing::Test {
protected:
    static void SetUpTestSuite() {
        server_ = new StructureServer;
        server_->serve("1bna.bcif.gz", test::gzipBytes(dnaAsBcif()));
        server_->serve("3bna.bcif.gz", dnaAsBcif());
        server_->serve("A2BC19.bcif", dnaAsBcif());
        const std::string water = test::readContents(NACRE_SOURCE_DIR "/tests/fuzz/seeds/water.cif");
        server_->serve("2cif.cif.gz", test::gzipBytes(water));
        server_->serve("P12345.cif", water);
        const std::string sdf = test::readContents(NACRE_SOURCE_DIR "/tests/fuzz/seeds/water.sdf");
        server_->serve("compound_cid_962_record_SDF_record_type=3d", sdf);
        server_->serve("compound_name_water%20%2F%3F_record_SDF_record_type=3d", sdf);
        server_->serve("compound_cid_7_record_SDF_record_type=2d", sdf);
    }
    static void TearDownTestSuite() {
        delete server_;
        server_ = nullptr;
    }

    void SetUp() override {
        settings_.cacheFolder = folder_ / "cache";
        settings_.limits.patience = std::chrono::seconds(2);
        before_ = server_->requests().size();
    }

    /// Downloads INPUT from the server that serves in a way.
    Molecule get(const std::string& way, const std::string& input, const ReadOptions& options = {}) {
        settings_.environment = [&](const char* name) {
            return std::string(name).find("_URL") == std::string::npos ? std::string() : server_->base(way);
        };
        return downloadMolecule(*parseDatabaseId(input), options, settings_);
    }
    /// The one line that it fails with.
    std::string failure(const std::string& way, const std::string& input = "pdb:1bna") {
        try {
            get(way, input);
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
            EXPECT_EQ(std::string(error.what()).rfind("cannot download: " + input + ": ", 0), 0u) << error.what();
            return error.what();
        }
        ADD_FAILURE() << way << " did not fail";
        return {};
    }
    /// Requests since the test began.
    std::vector<std::string> requests() const {
        const auto all = server_->requests();
        return {all.begin() + static_cast<std::ptrdiff_t>(before_), all.end()};
    }
    std::vector<std::string> kept() const {
        std::vector<std::string> names;
        if (fs::exists(settings_.cacheFolder))
            for (const auto& entry : fs::directory_iterator(settings_.cacheFolder))
                if (entry.path().filename() != "CACHEDIR.TAG") names.push_back(entry.path().filename().string());
        std::sort(names.begin(), names.end());
        return names;
    }

    using Names = std::vector<std::string>;
    static StructureServer* server_;
    TemporaryFolder folder_;
    DownloadSettings settings_;
    std::size_t before_ = 0;
};
StructureServer* Download::server_ = nullptr;

TEST_F(Download, BinaryCifIsAskedForFirstAndOnlyOnce) {
    EXPECT_EQ(get("ok", "pdb:1BNA").atoms.size(), kDnaAtoms);
    EXPECT_EQ(requests(), Names{"GET /ok/1bna.bcif.gz - -"});
    EXPECT_EQ(kept(), Names{"pdb-1bna.bcif.gz"});
    EXPECT_EQ(get("ok", "pdb:pdb_00001bna").atoms.size(), kDnaAtoms);
    EXPECT_EQ(requests().size(), 1u);
}

TEST_F(Download, MmcifWhereThereIsNoBinaryCif) {
    EXPECT_EQ(get("ok", "pdb:2cif").atoms.size(), 2u);
    EXPECT_EQ(requests(), (Names{"GET /ok/2cif.bcif.gz - -", "GET /ok/2cif.cif.gz - -"}));
    EXPECT_EQ(kept(), Names{"pdb-2cif.cif.gz"});
    EXPECT_EQ(get("ok", "pdb:2cif").atoms.size(), 2u);
    EXPECT_EQ(requests().size(), 2u);
}

TEST_F(Download, CompoundsByNumberAndName) {
    EXPECT_EQ(get("ok", "pubchem:962").atoms.size(), 3u);
    EXPECT_EQ(get("ok", "pubchem:water /?").atoms.size(), 3u);
    EXPECT_EQ(requests()[1], "GET /ok/compound/name/water%20%2F%3F/record/SDF?record_type=3d - -");
    const Molecule flat = get("ok", "pubchem:7");
    EXPECT_EQ(flat.atoms.size(), 3u);
    ASSERT_FALSE(flat.warnings.empty());
    EXPECT_NE(flat.warnings.back().find("no 3D"), std::string::npos);
}

TEST_F(Download, PredictionsByTheListThatNamesThem) {
    EXPECT_EQ(get("predictions", "afdb:A2BC19").atoms.size(), kDnaAtoms);
    EXPECT_EQ(requests(), (Names{"GET /predictions/api/prediction/A2BC19 - -", "GET /ok/A2BC19.bcif - -"}));
    EXPECT_EQ(get("predictions", "afdb:P12345").atoms.size(), 2u) << "no BinaryCIF: mmCIF";
    EXPECT_NE(failure("no_predictions", "afdb:Q9H0H5").find("no such entry"), std::string::npos);
    EXPECT_NE(failure("bad_predictions", "afdb:Q9H0H5").find("no usable address"), std::string::npos);
    EXPECT_NE(failure("html", "afdb:Q9H0H5").find("not a list of predictions"), std::string::npos);
}

TEST_F(Download, OtherModelsOfWhatIsKept) {
    ReadOptions second{.model = 2};
    for (int turn = 0; turn < 2; ++turn) try {
            get("ok", "pdb:1bna", second);
            ADD_FAILURE();
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find("model"), std::string::npos) << error.what();
        }
    EXPECT_EQ(requests().size(), 1u) << "the file is whole: it is kept, and no other is asked for";
    EXPECT_EQ(get("ok", "pdb:1bna").atoms.size(), kDnaAtoms);
    EXPECT_EQ(requests().size(), 1u);
}

TEST_F(Download, OfflineTakesTheCacheAlone) {
    settings_.offline = true;
    EXPECT_NE(failure("ok").find("--offline"), std::string::npos);
    settings_.offline = false;
    get("ok", "pdb:1bna");
    settings_.offline = true;
    EXPECT_EQ(get("ok", "pdb:1bna").atoms.size(), kDnaAtoms);
    EXPECT_EQ(requests().size(), 1u);
}

TEST_F(Download, WithoutACacheEveryRunAsks) {
    settings_.cacheFolder.clear();
    EXPECT_EQ(get("ok", "pdb:1bna").atoms.size(), kDnaAtoms);
    EXPECT_EQ(get("drop_once", "pdb:3bna").atoms.size(), kDnaAtoms);
    EXPECT_EQ(requests().size(), 3u);
    EXPECT_EQ(folder_.count(), 0u);
}

TEST_F(Download, SlowServersAreWaitedFor) {
    std::vector<double> shares;
    settings_.onProgress = [&](double share) { shares.push_back(share); };
    EXPECT_EQ(get("slow", "pdb:1bna").atoms.size(), kDnaAtoms);  // 3 seconds, more than the patience
    ASSERT_GT(shares.size(), 5u);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_LT(shares.front(), 0.2);
    EXPECT_DOUBLE_EQ(shares.back(), 1.0);
}

TEST_F(Download, ServersThatSayNothingAreNot) {
    EXPECT_NE(failure("silent", "pubchem:962").find("2 seconds"), std::string::npos);
}

TEST_F(Download, WhatStallsIsGoneOnWithByTheNextRun) {
    for (const char* way : {"stall", "trickle"}) {
        EXPECT_NE(failure(way).find("hardly any data"), std::string::npos) << way;
        EXPECT_EQ(kept(), (Names{"pdb-1bna.bcif.gz.part", "pdb-1bna.bcif.gz.tag"})) << way;
    }
}

TEST_F(Download, ALostConnectionIsGoneOnWith) {
    EXPECT_EQ(get("drop_once", "pdb:1bna").atoms.size(), kDnaAtoms);
    const auto asked = requests();
    ASSERT_EQ(asked.size(), 2u);
    EXPECT_NE(asked[1].find(" bytes="), std::string::npos) << asked[1];
    EXPECT_NE(asked[1].find("- \"v1\""), std::string::npos) << asked[1];
    EXPECT_EQ(kept(), Names{"pdb-1bna.bcif.gz"});
}

TEST_F(Download, AnotherRunGoesOnWhereOneEnded) {
    // Every connection brings half of what is left; three to a run and place.
    EXPECT_NE(failure("drop").find("connection was lost"), std::string::npos);
    const auto part = fs::file_size(fs::path(settings_.cacheFolder) / "pdb-1bna.bcif.gz.part");
    before_ = server_->requests().size();
    failure("drop");
    EXPECT_NE(requests()[0].find(" bytes=" + std::to_string(part) + "- "), std::string::npos) << requests()[0];
    EXPECT_GT(fs::file_size(fs::path(settings_.cacheFolder) / "pdb-1bna.bcif.gz.part"), part);
}

TEST_F(Download, AChangedFileStartsAnew) {
    EXPECT_EQ(get("drop_changed", "pdb:1bna").atoms.size(), kDnaAtoms);
    EXPECT_NE(requests()[1].find(" bytes=500- \"old\""), std::string::npos) << requests()[1];
    EXPECT_EQ(get("drop_untagged", "pdb:2cif").atoms.size(), 2u);
}

TEST_F(Download, APartThatIsLongerThanTheFileStartsAnew) {
    get("ok", "pdb:1bna");
    const fs::path entry = fs::path(settings_.cacheFolder) / "pdb-1bna.bcif.gz";
    fs::rename(entry, entry.string() + ".part");
    std::ofstream(entry.string() + ".tag") << server_->base("ok") << "/1bna.bcif.gz\n\"v1\"\n";
    EXPECT_EQ(get("ok", "pdb:1bna").atoms.size(), kDnaAtoms);
    EXPECT_EQ(kept(), Names{"pdb-1bna.bcif.gz"});
}

TEST_F(Download, TheWrongRangeIsRefused) { EXPECT_NE(failure("wrong_range").find("wrong part"), std::string::npos); }

TEST_F(Download, ChunkedAnswersEndWhereTheySay) {
    EXPECT_EQ(get("chunked", "pdb:1bna").atoms.size(), kDnaAtoms);
    EXPECT_NE(failure("chunked_cut", "pdb:2cif").find("connection was lost"), std::string::npos);
}

TEST_F(Download, TooMuchIsRefused) {
    settings_.limits.maxBytes = 1000000;
    EXPECT_NE(failure("huge").find("larger than the limit of 1000000 bytes"), std::string::npos);
    EXPECT_NE(failure("endless").find("larger than the limit of 1000000 bytes"), std::string::npos);
    EXPECT_EQ(kept(), Names{});
}

struct Answer {
    const char* way;
    const char* says;
};
void PrintTo(const Answer& answer, std::ostream* out) { *out << answer.way; }
class BadAnswer : public Download, public testing::WithParamInterface<Answer> {};

TEST_P(BadAnswer, IsOneClearLineAndLeavesNothing) {
    const std::string line = failure(GetParam().way);
    EXPECT_NE(line.find(GetParam().says), std::string::npos) << line;
    EXPECT_EQ(kept(), Names{});
}

INSTANTIATE_TEST_SUITE_P(Download, BadAnswer,
                         testing::Values(Answer{"html", "1bna.cif.gz"}, Answer{"empty", "empty"},
                                         Answer{"busy", "status 503 (it is busy"}, Answer{"untrue", "gzip"},
                                         Answer{"circle", "more than 5 redirections"},
                                         Answer{"no_http", "no HTTP status and no headers"},
                                         Answer{"to_file", "another protocol"}, Answer{"to_ftp", "another protocol"},
                                         Answer{"to_https", "another protocol"},
                                         Answer{"ok/nowhere", "no such entry"}));

TEST_F(Download, RedirectionsAreFollowed) { EXPECT_EQ(get("redirect", "pdb:1bna").atoms.size(), kDnaAtoms); }

TEST_F(Download, ServersThatAreNotThere) {
    settings_.environment = [](const char*) { return std::string("http://localhost:1"); };
    EXPECT_THROW(downloadMolecule(*parseDatabaseId("pdb:1bna"), {}, settings_), Error);
    settings_.environment = [](const char*) { return std::string("http://no-such-host.invalid"); };
    EXPECT_THROW(downloadMolecule(*parseDatabaseId("pdb:1bna"), {}, settings_), Error);
    EXPECT_EQ(kept(), Names{});
}

TEST_F(Download, WhatIsTrueOfBothAddressesIsSaidOnce) {
    const auto failureAt = [&](const char* base, const char* input, bool verbose) {
        settings_.verbose = verbose;
        settings_.environment = [=](const char*) { return std::string(base); };
        try {
            downloadMolecule(*parseDatabaseId(input), {}, settings_);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(failureAt("http://no-such-host.invalid", "pdb:1bna", false),
              "cannot download: pdb:1bna: server not found: check your connection");
    EXPECT_EQ(failureAt("http://no-such-host.invalid", "pdb:1bna", true),
              "cannot download: pdb:1bna: http://no-such-host.invalid/1bna.bcif.gz, "
              "http://no-such-host.invalid/1bna.cif.gz: server not found: check your connection");
    EXPECT_EQ(failureAt("http://localhost:1", "afdb:P69905", false),
              "cannot download: afdb:P69905: server not reachable: check your connection");
    EXPECT_EQ(failureAt("http://localhost:1", "afdb:P69905", true),
              "cannot download: afdb:P69905: http://localhost:1/api/prediction/P69905: "
              "server not reachable: check your connection");
}

TEST_F(Download, AKeptFileThatWasDamagedIsFetchedAnew) {
    get("ok", "pdb:1bna");
    const fs::path entry = fs::path(settings_.cacheFolder) / "pdb-1bna.bcif.gz";
    fs::resize_file(entry, fs::file_size(entry) / 2);
    EXPECT_EQ(get("ok", "pdb:1bna").atoms.size(), kDnaAtoms);
    EXPECT_EQ(requests().size(), 2u);
    EXPECT_EQ(kept(), Names{"pdb-1bna.bcif.gz"});
}

TEST_F(Download, LimitsOfTheEnvironment) {
    const auto with = [](const char* seconds) {
        return httpLimits(
            [=](const char* name) { return std::string(name) == "NACRE_DOWNLOAD_TIMEOUT" ? seconds : "/ca.pem"; });
    };
    EXPECT_EQ(with("7").patience.count(), 7);
    EXPECT_EQ(with("").patience.count(), 30);
    EXPECT_EQ(with("").certificates, "/ca.pem");
    for (const char* bad : {"0", "-1", "x", "5s", "1e3", "99999999999999999999"}) EXPECT_THROW(with(bad), Error) << bad;
}

/// A server of https, with a certificate that nobody but a test trusts.
TEST(SecureDownload, TrustsNobodyUnknownAndStaysSecure) {
    const TemporaryFolder folder;
    const std::string certificate = folder / "certificate.pem", key = folder / "key.pem";
    ASSERT_EQ(std::system(("openssl req -x509 -newkey rsa:2048 -nodes -days 2 -subj /CN=localhost -addext "
                           "subjectAltName=DNS:localhost -keyout '" +
                           key + "' -out '" + certificate + "' 2>/dev/null")
                              .c_str()),
              0);
    const StructureServer server(certificate, key);
    server.serve("1bna.bcif.gz", dnaAsBcif());
    DownloadSettings settings;
    const auto get = [&](const std::string& way) {
        settings.environment = [&](const char*) { return "https://localhost:" + server.port() + "/" + way; };
        return downloadMolecule(*parseDatabaseId("pdb:1bna"), {}, settings);
    };
    const auto failure = [&](const std::string& way) -> std::string { return test::errorText([&] { get(way); }); };
    EXPECT_NE(failure("ok").find("certificate"), std::string::npos) << failure("ok");
    settings.limits.certificates = certificate;
    EXPECT_EQ(get("ok").atoms.size(), kDnaAtoms);
    EXPECT_NE(failure("to_http").find("another protocol"), std::string::npos) << failure("to_http");
    settings.limits.certificates = folder / "none.pem";
    EXPECT_NE(failure("ok"), "");
}

}  // namespace
}  // namespace nacre::app
