#include "app/cli/batch_files.h"

#include <filesystem>
#include <fstream>
#include <vector>

#include "app/cli/command_spec.h"
#include "app/input/input_files.h"

namespace nacre::app {
namespace fs = std::filesystem;

namespace {

std::size_t placeOf(const std::string& path) {
    std::error_code error;
    const fs::path place = fs::weakly_canonical(fs::absolute(path, error), error);
    return std::hash<std::string>{}(error ? path : place.string());
}

std::vector<std::string> inputsOf(const PictureDescription& job) {
    std::vector<std::string> inputs{filePathOf(job.input), job.view, trajectoryPathOf(job.input)};
    for (const FurtherInput& further : job.input.further) {
        InputOptions each = job.input;
        each.path = further.path;
        each.hash = further.hash;
        inputs.push_back(filePathOf(each));
    }
    return inputs;
}

/// Whether a non-empty file exists that is not the output of statsJson().
bool isOther(const std::string& path) {
    constexpr std::string_view kBegin = "{\n  \"view\": {\n";
    std::error_code error;
    if (!fs::is_regular_file(path, error)) return false;
    std::ifstream file(path, std::ios::binary);
    std::string begin(kBegin.size(), '\0');
    file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    return file.gcount() > 0 && begin != kBegin;
}

}  // namespace

BatchFiles::BatchFiles(const std::string& jobs) {
    if (jobs != "-") files_.emplace(placeOf(jobs), false);
}

void BatchFiles::claim(const PictureDescription& job) {
    const std::pair<const char*, const std::string&> outputs[] = {
        {"output", job.output}, {"layers", job.layers}, {"stats", job.stats}};
    if (isOther(job.stats)) throw UsageError("\"stats\": the existing file is not a stats file: " + job.stats);
    const std::lock_guard lock(turn_);
    for (const auto& [name, path] : outputs) {
        const auto known = path.empty() ? files_.end() : files_.find(placeOf(path));
        if (known == files_.end()) continue;
        throw UsageError("\"" + std::string(name) + "\": an earlier job " +
                         (known->second ? "writes the same file: " : "reads this file: ") + path);
    }
    for (const std::string& path : inputsOf(job))
        if (!path.empty()) files_.emplace(placeOf(path), false);
    for (const auto& [name, path] : outputs)
        if (!path.empty()) files_.emplace(placeOf(path), true);
}

}  // namespace nacre::app
