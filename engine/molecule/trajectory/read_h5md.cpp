// Trajectories in HDF5; formats/read_h5md.cpp reads such a file as a structure.
#include "engine/molecule/trajectory/trajectory_file.h"

#ifdef NACRE_HDF5
#include <optional>

#include "engine/molecule/trajectory/h5md_data.h"

namespace nacre {
namespace {

class H5md : public FileTrajectory {
public:
    explicit H5md(OwnedFile file) : FileTrajectory(std::move(file), "h5md") {
        const Hdf5Lock lock;
        try {
            data_.emplace(H5mdData::ofFile(name_));
        } catch (const Hdf5Fault& fault) {
            file_->fail(fault.what());
        }
        atoms_ = static_cast<std::size_t>(data_->atoms());
        frames_ = static_cast<std::size_t>(data_->frames());
        try {
            checkedAtoms(*file_, static_cast<std::int64_t>(atoms_));
        } catch (...) {
            data_.reset();  // while the lock is held
            throw;
        }
    }

    ~H5md() override {
        const Hdf5Lock lock;
        data_.reset();
    }

private:
    void readWhole(std::size_t frame, TrajectoryFrame& result) override {
        const Hdf5Lock lock;
        if (!data_->read(frame, result)) damaged(frame);
        for (std::size_t k = 0; result.box && k < 3; ++k)
            if (!data_->repeats()[k]) (*result.box)[k] = glm::vec3(0);
    }

    std::optional<H5mdData> data_;
};

}  // namespace

std::unique_ptr<Trajectory> openH5md(OwnedFile file) { return std::make_unique<H5md>(std::move(file)); }

}  // namespace nacre

#else

namespace nacre {

std::unique_ptr<Trajectory> openH5md(OwnedFile file) { file->fail("it is HDF5, which this program was built without"); }

}  // namespace nacre

#endif
