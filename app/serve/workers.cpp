#include "app/serve/workers.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>

#include "app/download/database_id.h"
#include "app/download/load_molecule.h"
#include "app/drawing/drawing.h"
#include "app/files/messages.h"
#include "app/files/spare_memory.h"
#include "app/images/image_file.h"
#include "app/input/map_input.h"
#include "engine/error.h"
#include "engine/threads.h"

namespace nacre::app {
namespace {

/// A picture in its format. Lack of space may be temporary; the texts of other errors name the server's folders.
std::string encoded(const Picture& picture, const PictureDescription& description) {
    try {
        return encodePicture(fileExtension(description.output), picture, chooseFormat(description));
    } catch (const Error& error) {
        const std::string_view why = error.what();
        for (const int code : {ENOSPC, EDQUOT, EMFILE, ENFILE, ENOMEM})
            if (why.find(std::strerror(code)) != std::string_view::npos) throw Problem(503, "no room for the picture");
        throw Problem(500, "the picture cannot be encoded");
    }
}

/// @throws Problem after the deadline
void checkTime(Clock::time_point deadline) {
    if (Clock::now() > deadline) throw Problem(503, "the answer took too long");
}

/// A drawing keeps its description, but must not keep open the files of its molecule.
PictureDescription withoutOpenFiles(PictureDescription description) {
    description.input.opened = nullptr;
    for (FurtherInput& further : description.input.further) further.opened = nullptr;
    return description;
}

}  // namespace

class Workers::Worker {
public:
    /// @param devices  counts created renderers
    Worker(const DeviceOptions& device, std::atomic<std::uint64_t>& devices) : device_(device), devices_(devices) {
        makeCanvas();
    }

    /// Whether it has the molecule of a request.
    bool has(const PictureRequest& request) const { return molecule_ && held_ == request.molecule; }

    /// Replaces a lost device, and then draws the picture once more.
    /// @param deadline  afterwards nobody waits for the picture: it ends between two steps
    ServedPicture draw(const PictureRequest& request, Clock::time_point deadline) {
        try {
            return drawOnce(request, deadline);
        } catch (const Error&) {
            if (!isLost()) throw;
        }
        return drawOnce(request, deadline);
    }

    /// @param check  called between its steps; ends it by throwing @throws Problem
    static Molecule load(const InputOptions& input, const std::function<void(double)>& check) {
        try {
            return loadMolecule(input, check, check, [&] { check(0); });
        } catch (const Error& error) {
            throw unreadable(error, input.path);
        }
    }

    /// The device may also have failed to open.
    bool isLost() const { return !canvas_ || canvas_->isLost(); }

    bool idle = false;  ///< waits for a task; under the workers' lock

private:
    void makeCanvas() {
        canvas_.emplace(device_);
        ++devices_;
    }

    ServedPicture drawOnce(const PictureRequest& request, Clock::time_point deadline) {
        const PictureDescription& description = request.description;
        const HeardMessages heard;
        if (!canvas_ || canvas_->isSpent()) {
            canvas_.reset();
            makeCanvas();
        }
        const auto check = [deadline](double) { checkTime(deadline); };
        if (!has(request)) {
            drawing_.forget();
            molecule_.reset();
            map_.reset();
            molecule_.emplace(load(description.input, check));
            if (description.input.opened && isMap(description.input)) map_ = openMap(description.input);
            held_ = request.molecule;
            asAsked_ = moleculeKey(description) == held_;
        }
        check(0);
        drawing_.prepare(*molecule_, withoutOpenFiles(description));
        check(0);
        drawing_.settings.occlusion.onProgress = check;
        std::vector<std::string> said = heard.warnings;
        said.insert(said.end(), drawing_.warnings.begin(), drawing_.warnings.end());
        std::string picture = encoded(drawing_.draw(*canvas_, &said), description);
        const bool asAsked = asAsked_;
        if (!asAsked_) molecule_.reset();  // its content does not match its key
        return {std::move(picture), std::move(said), asAsked};
    }

    const DeviceOptions& device_;
    std::atomic<std::uint64_t>& devices_;
    std::optional<Canvas> canvas_;
    std::optional<Molecule> molecule_;
    std::shared_ptr<const DensityMap> map_;  ///< null: the input is no map
    std::string held_;                       ///< PictureRequest::molecule of both
    bool asAsked_ = true;                    ///< none of its files changed between that request and its reading
    Drawing drawing_;
};

Problem unreadable(const std::exception& error, const std::string& place) {
    const bool missing = parseDatabaseId(place) || dynamic_cast<const InputMissing*>(&error);
    return {missing ? 404 : 422, error.what()};
}

Workers::Workers(const ServeOptions& options) : options_(options) {
    for (int i = 0; i < options.workers; ++i)
        workers_.push_back(std::make_unique<Worker>(options.picture.device, devices_));
    threads_.reserve(workers_.size());
    for (const std::unique_ptr<Worker>& worker : workers_)
        if (std::thread thread; mayStart(thread, [&] { work(*worker); })) threads_.push_back(std::move(thread));
    if (threads_.empty()) throw Error("cannot serve", "", "no thread can be started");
}

Workers::~Workers() {
    {
        const std::lock_guard lock(turn_);
        stopping_ = true;
        for (const std::shared_ptr<Task>& task : tasks_)
            task->promise.set_exception(std::make_exception_ptr(Problem(503, "the server stops")));
        tasks_.clear();
    }
    wake_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

std::size_t Workers::waiting() const {
    const std::lock_guard lock(turn_);
    return tasks_.size();
}

ServedPicture Workers::draw(const PictureRequest& request, const std::string& newest) {
    const auto task = std::make_shared<Task>();
    task->request = request;
    task->newest = newest;
    return result(task);
}

std::string Workers::run(Work work) {
    const auto task = std::make_shared<Task>();
    task->work = std::move(work);
    return result(task).bytes;
}

ServedPicture Workers::result(const std::shared_ptr<Task>& task) {
    std::future<ServedPicture> picture = task->promise.get_future();
    task->deadline =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options_.seconds));
    {
        const std::lock_guard lock(turn_);
        if (stopping_) throw Problem(503, "the server stops");
        if (!task->newest.empty()) {
            const auto older = std::find_if(tasks_.begin(), tasks_.end(), [&](const std::shared_ptr<Task>& one) {
                return one->newest == task->newest;
            });
            if (older != tasks_.end()) {
                (*older)->promise.set_exception(std::make_exception_ptr(Problem(429, "a newer request replaced it")));
                tasks_.erase(older);
            }
        }
        if (tasks_.size() >= static_cast<std::size_t>(options_.queue))
            throw Problem(429, std::to_string(options_.queue) + " requests are already waiting");
        tasks_.push_back(task);
    }
    wake_.notify_all();
    if (picture.wait_until(task->deadline) == std::future_status::ready) return picture.get();
    const std::lock_guard lock(turn_);
    task->given = true;
    throw Problem(503, "the answer took longer than " + std::to_string(static_cast<int>(options_.seconds)) + " s");
}

/// A task for a worker: the first that needs its molecule, else the first whose molecule no other idle worker has.
std::optional<std::size_t> Workers::choice(const Worker& worker) const {
    constexpr std::size_t kLookAhead = 8;  // farther ones wait their turn, so that none waits forever
    const std::size_t end = std::min(kLookAhead, tasks_.size());
    for (std::size_t i = 0; i < end; ++i)
        if (worker.has(tasks_[i]->request)) return i;
    for (std::size_t i = 0; i < end; ++i)
        if (std::ranges::none_of(workers_, [&](const std::unique_ptr<Worker>& other) {
                return other.get() != &worker && other->idle && other->has(tasks_[i]->request);
            }))
            return i;
    return {};
}

std::shared_ptr<Workers::Task> Workers::next(Worker& worker) {
    std::unique_lock lock(turn_);
    worker.idle = true;
    std::optional<std::size_t> chosen;
    wake_.wait(lock, [&] {
        chosen = choice(worker);
        return stopping_ || chosen;
    });
    worker.idle = false;
    if (!chosen) return nullptr;
    const auto at = tasks_.begin() + static_cast<std::ptrdiff_t>(*chosen);
    const std::shared_ptr<Task> task = *at;
    tasks_.erase(at);
    if (!tasks_.empty()) wake_.notify_all();  // others may take tasks that they left to this worker
    return task;
}

/// @throws Problem, std::bad_alloc
ServedPicture Workers::done(Worker& worker, const Task& task) {
    try {
        if (!task.work) return worker.draw(task.request, task.deadline);
        return {task.work([&task] { checkTime(task.deadline); }), {}, true};
    } catch (const Problem&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw Problem(worker.isLost() ? 503 : 422, error.what());
    }
}

void Workers::work(Worker& worker) {
    static const std::exception_ptr noMemory = std::make_exception_ptr(Problem(503, "out of memory"));  // preallocated
    while (const std::shared_ptr<Task> task = next(worker)) {
        {
            const std::lock_guard lock(turn_);
            if (task->given) continue;
        }
        try {
            task->promise.set_value(done(worker, *task));
        } catch (const std::bad_alloc&) {
            task->promise.set_exception(noMemory);
        } catch (...) {
            task->promise.set_exception(std::current_exception());
        }
        givePicturesMemoryBack();
    }
}

}  // namespace nacre::app
