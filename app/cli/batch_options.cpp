#include "app/cli/batch_options.h"

#include <algorithm>
#include <thread>

#include "app/cli/picture_options.h"
#include "app/drawing/complete.h"
#include "app/files/output_file.h"

namespace nacre::app {
namespace {

constexpr int kMostJobs = 64;

/// One device draws all: these are the batch's, and no job's.
constexpr Topics kOfTheDevice = Topic::device | Topic::path | Topic::validation;
/// These are a job's alone.
constexpr Topics kOfOneJob = Topic::input | Topic::files;

}  // namespace

void addBatch(CommandSpec& command, BatchOptions& options) {
    command
        .value("JOBS", "", "", "A file of jobs, one JSON object per line; - for standard input",
               [&](const std::string& text) { options.path = fileName(text); })
        .required = true;
    options.parallel = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, unsigned{kMostJobs}));
    command.value(
        "--jobs", "N", "one per processor",
        "Pictures processed at the same time, 1 to 64; files are read and written while one is drawn",
        [&](const std::string& text) { options.parallel = static_cast<int>(parseInteger(text, 1, kMostJobs)); });
    command.flag("--resume", options.resume, "Skip jobs whose files exist");
    // Applies the common options now, so that errors show before any work.
    addPicture(command, options.tried, kEveryTopic & ~kOfTheDevice & ~kOfOneJob, &options.common);
    addPicture(command, options.tried, kOfTheDevice);
}

PictureDescription jobOf(const std::string& json, const BatchOptions& batch) {
    std::vector<OptionValue> values = batch.common;
    for (OptionValue& value : optionValuesOf(json)) {
        if (has(kOfTheDevice, option(value.key).topic) || value.key == "capture")
            throw UsageError("\"" + value.key + "\" is the batch's: all jobs are drawn by one device");
        if (value.value == "-" || isStandardOutput(value.value))
            throw UsageError("\"" + value.key + "\": a job's files have names");
        values.push_back(std::move(value));
    }
    PictureDescription job;
    setOptions(values, job);
    if (job.output.empty()) throw UsageError("\"output\" is required");
    completePicture(job);
    return job;
}

}  // namespace nacre::app
