#include "app/cli/batch_options.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <thread>

#include "app/cli/common_options.h"
#include "app/cli/picture_options.h"
#include "app/files/output_file.h"

namespace nacre::app {
namespace {

constexpr int kMostJobs = 64;

/// One device draws all: these are the batch's, and no job's.
constexpr std::array<std::string_view, 5> kOfTheDevice = {"device", "visibility", "encoded-format", "validate",
                                                          "capture"};
/// These are a job's alone.
constexpr std::array<std::string_view, 5> kOfOneJob = {"input", "output", "layers", "stats", "capture"};

bool isOne(const std::string& name, std::span<const std::string_view> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

void addBatch(CommandSpec& command, BatchOptions& options) {
    command
        .add({"JOBS", "", "", "A file of jobs, one JSON object a line; - for standard input",
              [&](const std::string& text) { options.path = fileName(text); }})
        .required = true;
    options.parallel = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, unsigned{kMostJobs}));
    addValue(command, "--jobs", "N", "one a processor",
             "Pictures in work at once, 1 to 64: others are read and written while one is drawn",
             [&](const std::string& text) { options.parallel = static_cast<int>(parseInteger(text, 1, kMostJobs)); });
    addFlag(command, "--resume", options.resume, "Leave out jobs whose files are there");
    CommandSpec render{"render", "", ""};
    addRender(render, options.tried);
    for (const OptionSpec& option : render.options) {
        const std::string name = plainName(option);
        if (isOne(name, kOfOneJob)) continue;
        // Those that hold for every job are tried now, so that what is wrong is told before any work.
        command.add(isOne(name, kOfTheDevice) ? option : recorded(option, options.common));
    }
}

RenderOptions jobOf(const std::string& json, const BatchOptions& batch) {
    RenderOptions job;
    CommandSpec render{"render", "", ""};
    addRender(render, job);
    std::vector<OptionValue> values = batch.common;
    for (OptionValue& value : optionValuesOf(json, render)) {
        if (isOne(value.name, kOfTheDevice))
            throw UsageError("\"" + value.name + "\" is the batch's: all jobs are drawn by one device");
        if (value.value == "-" || isStandardOutput(value.value))
            throw UsageError("\"" + value.name + "\": a job's files have names");
        values.push_back(std::move(value));
    }
    setOptions(render, values);
    checkRender(job);
    return job;
}

}  // namespace nacre::app
