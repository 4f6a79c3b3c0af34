// NetCDF as AMBER writes trajectories and restart files (conventions AMBER and AMBERRESTART 1.0): classic NetCDF,
// versions 1, 2 and 5. Reads the header, and of the variables only `coordinates`, `cell_lengths` and `cell_angles`.
// NetCDF's own library would needlessly require HDF5.

#include <map>

#include "engine/molecule/trajectory/trajectory_file.h"

namespace nacre {
namespace {

constexpr std::uint32_t kDimensions = 10, kVariables = 11, kAttributes = 12;
constexpr std::uint64_t kMostEntries = 10'000, kLongestName = 1'000;
constexpr std::array<std::uint64_t, 12> kTypeBytes = {0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
constexpr std::uint32_t kFloat = 5, kDouble = 6;

struct NetcdfVariable {
    std::vector<std::uint64_t> dimensions;
    std::uint32_t type = 0;
    std::uint64_t begin = 0;
    std::uint64_t bytes = 0;  ///< of one record, or of all
    bool recorded = false;
};

std::uint64_t fourfold(std::uint64_t bytes) { return (bytes + 3) / 4 * 4; }

class NetcdfHead {
public:
    explicit NetcdfHead(const TrajectoryFile& file) : file_(file), numbers_(file, 3, kBigEndianSwapped) {
        version_ = numbers_.next<std::uint8_t>();
        if (version_ != 1 && version_ != 2 && version_ != 5) file.fail("its version of NetCDF is not known");
        records = count();
        streaming = version_ == 5 ? records == UINT64_MAX : records == UINT32_MAX;
        readDimensions();
        skipAttributes();
        readVariables();
    }

    std::uint64_t records = 0;
    bool streaming = false;                 ///< the number of records is unknown
    std::vector<std::uint64_t> dimensions;  ///< 0: the record dimension
    std::map<std::string, NetcdfVariable> variables;
    std::uint64_t recordBytes = 0;

private:
    std::uint64_t count() { return version_ == 5 ? numbers_.next<std::uint64_t>() : numbers_.next<std::uint32_t>(); }
    std::uint64_t entries(std::uint32_t expected) {
        const auto tag = numbers_.next<std::uint32_t>();
        const std::uint64_t n = count();
        if ((tag != expected && !(tag == 0 && n == 0)) || n > kMostEntries) file_.fail("its header is damaged");
        return n;
    }
    std::string name() {
        const std::uint64_t length = count();
        if (length > kLongestName) file_.fail("its header is damaged");
        std::string text(length, '\0');
        file_.read(numbers_.offset(), std::as_writable_bytes(std::span(text)));
        numbers_.skip(fourfold(length));
        return text;
    }
    std::uint32_t type() {
        const auto value = numbers_.next<std::uint32_t>();
        if (value == 0 || value >= kTypeBytes.size()) file_.fail("its header is damaged");
        return value;
    }
    void readDimensions() {
        for (std::uint64_t n = entries(kDimensions); n > 0; --n) {
            name();
            dimensions.push_back(count());
        }
    }
    void skipAttributes() {
        for (std::uint64_t n = entries(kAttributes); n > 0; --n) {
            name();
            const std::uint64_t bytes = kTypeBytes[type()], values = count();
            if (values > file_.size()) file_.fail("its header is damaged");
            numbers_.skip(fourfold(values * bytes));
        }
    }
    void readVariables() {
        std::size_t recorded = 0;
        std::uint64_t unpadded = 0;
        for (std::uint64_t n = entries(kVariables); n > 0; --n) {
            const std::string variable = name();
            NetcdfVariable v;
            const std::uint64_t rank = count();
            if (rank > kMostEntries) file_.fail("its header is damaged");
            v.bytes = 1;
            for (std::uint64_t i = 0; i < rank; ++i) {
                const std::uint64_t dimension = count();
                if (dimension >= dimensions.size()) file_.fail("its header is damaged");
                const std::uint64_t length = dimensions[dimension];
                v.dimensions.push_back(length);
                if (i == 0 && length == 0)
                    v.recorded = true;
                else if (length > file_.size() || (v.bytes *= length) > file_.size())
                    file_.fail("its header lists more than the file holds");
            }
            skipAttributes();
            v.type = type();
            v.bytes *= kTypeBytes[v.type];
            count();  // skipped: the header's size field is too small for large variables
            v.begin = version_ == 1 ? numbers_.next<std::uint32_t>() : numbers_.next<std::uint64_t>();
            if (v.recorded) {
                ++recorded;
                unpadded = v.bytes;
                recordBytes += fourfold(v.bytes);
            }
            variables[variable] = v;
        }
        if (recorded == 1) recordBytes = unpadded;  // a single one is not padded
    }

    const TrajectoryFile& file_;
    NumberReader numbers_;
    int version_ = 0;
};

class Netcdf : public FileTrajectory {
public:
    explicit Netcdf(OwnedFile file) : FileTrajectory(std::move(file), "netcdf") {
        const NetcdfHead head(*file_);
        const auto find = [&](const char* name) {
            const auto found = head.variables.find(name);
            return found == head.variables.end() ? NetcdfVariable{} : found->second;
        };
        coordinates_ = find("coordinates");
        lengths_ = find("cell_lengths");
        angles_ = find("cell_angles");
        const auto& shape = coordinates_.dimensions;
        restart_ = !coordinates_.recorded && shape.size() == 2;
        if ((!coordinates_.recorded && !restart_) || shape.size() != (restart_ ? 2 : 3) || shape.back() != 3 ||
            !isReal(coordinates_))
            file_->fail("it has no coordinates as AMBER writes them (frame, atom, spatial)");
        atoms_ = checkedAtoms(*file_, static_cast<std::int64_t>(shape[restart_ ? 0 : 1]));
        times_ = find("time");
        hasCell_ = isCell(lengths_) && isCell(angles_);
        if (restart_) {
            if (!file_->holds(coordinates_.begin, coordinates_.bytes)) file_->fail("it has no whole frame");
            frames_ = 1;
            return;
        }
        recordBytes_ = head.recordBytes;
        const std::uint64_t first = coordinates_.begin + coordinates_.bytes;
        std::uint64_t whole = 0;
        if (file_->holds(0, first)) whole = 1 + (file_->size() - first) / recordBytes_;
        frames_ = static_cast<std::size_t>(head.streaming ? whole : std::min(whole, head.records));
        cutOff_ = !head.streaming && whole < head.records;
        if (!frames_) file_->fail("it has no whole frame");
        hasTimes_ = times_.recorded && times_.dimensions.size() == 1 && isReal(times_);
    }

private:
    static bool isReal(const NetcdfVariable& v) { return v.type == kFloat || v.type == kDouble; }
    bool isCell(const NetcdfVariable& v) const {
        const std::size_t rank = restart_ ? 1 : 2;
        return v.recorded != restart_ && v.dimensions.size() == rank && v.dimensions.back() == 3 && isReal(v);
    }
    glm::dvec3 readVector(const NetcdfVariable& v, std::size_t frame) const {
        NumberReader numbers = numbersAt(v.begin + frame * recordBytes_);
        glm::dvec3 value;
        for (int k = 0; k < 3; ++k) value[k] = numbers.next(v.type == kDouble);
        return value;
    }

    void readWhole(std::size_t frame, TrajectoryFrame& result) override {
        if (hasTimes_) result.time = numbersAt(times_.begin + frame * recordBytes_).next(times_.type == kDouble);
        if (hasCell_) result.box = makeBox(readVector(lengths_, frame), readVector(angles_, frame));
        readPositions(coordinates_.begin + frame * recordBytes_, coordinates_.type == kDouble, 1, result);
    }

    NetcdfVariable coordinates_, lengths_, angles_, times_;
    std::uint64_t recordBytes_ = 0;
    bool hasCell_ = false, hasTimes_ = false;
    bool restart_ = false;  ///< one frame, without records (RST7)
};

}  // namespace

std::unique_ptr<Trajectory> openNetcdf(OwnedFile file) { return std::make_unique<Netcdf>(std::move(file)); }

}  // namespace nacre
