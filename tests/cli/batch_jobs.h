#pragma once
// Jobs of `nacre batch`, and what it reports of them.

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/run_program.h"

namespace nacre::test {

/// Writes jobs.jsonl.
inline void writeJobs(const TemporaryFolder& folder, const std::vector<std::string>& lines) {
    std::ofstream file(folder / "jobs.jsonl");
    for (const std::string& line : lines) file << line << '\n';
}

/// The report, by the job's line.
inline std::map<int, nlohmann::json> parseReport(const std::string& out) {
    std::map<int, nlohmann::json> report;
    std::istringstream lines(out);
    for (std::string line; std::getline(lines, line);) {
        const auto told = nlohmann::json::parse(line);
        EXPECT_TRUE(report.emplace(told["job"].get<int>(), told).second) << line;
    }
    return report;
}

/// One line of jobs.jsonl.
inline std::string job(const std::string& input, const std::string& output, const std::string& more = "") {
    return R"({"input": ")" + input + R"(", "output": ")" + output + "\"" + (more.empty() ? "" : ", " + more) + "}";
}

}  // namespace nacre::test
