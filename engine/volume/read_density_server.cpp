// BinaryCIF of density servers (github.com/molstar/molstar, servers/volume): the category volume_data_3d_info states
// the box as fractions of the cell, and volume_data_3d has the values.
#include <algorithm>
#include <cmath>

#include "engine/molecule/formats/bcif_column.h"
#include "engine/volume/map_grid.h"

namespace nacre {
namespace {

using ValueKind = MsgpackValue::Kind;

class DensityServerReader {
public:
    DensityServerReader(const std::string& name, std::string_view bytes, const MapLimits& limits)
        : name_(name), bytes_(bytes), limits_(limits) {}

    DensityMap read() {
        const MsgpackValue root = parseMsgpack(name_, bytes_);
        const auto blocks = root.find("dataBlocks");
        if (!blocks || !blocks->is(ValueKind::array)) fail("it has no dataBlocks, so it is not BinaryCIF");
        std::vector<MsgpackValue> found;  // blocks with a volume
        MsgpackElements elements(*blocks);
        for (MsgpackValue block; elements.next(block);)
            if (category(block, "volume_data_3d_info") && category(block, "volume_data_3d") && isChannel(block))
                found.push_back(block);
        if (found.empty())
            fail(limits_.channel.empty() ? "it has no volume_data_3d: no map"
                                         : "it has no map of the channel '" + printable(limits_.channel) + "'");
        DensityMap map = readMapBlock(found.front());
        if (found.size() > 1)
            map.warnings.push_back("the file has " + std::to_string(found.size()) + " maps: the first is drawn");
        return map;
    }

private:
    [[noreturn]] void fail(const std::string& why) const { cannotReadMap(name_, why); }

    bool isChannel(const MsgpackValue& block) const {
        const auto header = block.find("header");
        const auto text = header ? header->asText() : std::nullopt;
        return limits_.channel.empty() || (text && lowerCase(*text) == lowerCase(limits_.channel));
    }
    static bool isNamed(const MsgpackValue& map, std::string_view name) {
        const auto named = map.find("name");
        const auto text = named ? named->asText() : std::nullopt;
        if (!text) return false;
        std::string lower = lowerCase(*text);
        if (startsWith(lower, "_")) lower.erase(0, 1);
        return lower == name;
    }
    /// Element of a list by name.
    static std::optional<MsgpackValue> named(const MsgpackValue& of, const char* list, std::string_view name) {
        const auto entries = of.find(list);
        if (!entries || !entries->is(ValueKind::array)) return {};
        MsgpackElements elements(*entries);
        for (MsgpackValue element; elements.next(element);)
            if (isNamed(element, name)) return element;
        return {};
    }
    static std::optional<MsgpackValue> category(const MsgpackValue& block, std::string_view name) {
        return named(block, "categories", name);
    }
    double number(const MsgpackValue& info, const std::string& key) const {
        const auto column = named(info, "columns", key);
        if (!column) fail("volume_data_3d_info has no " + key);
        try {
            const auto value = BcifColumn(*column, 1, 16).next().number();
            if (!value || !std::isfinite(*value)) fail("volume_data_3d_info." + key + " is not a number");
            return *value;
        } catch (const PackedFault& fault) {
            fail("volume_data_3d_info." + key + ": " + printable(fault.what(), 200));
        }
    }
    int whole(const MsgpackValue& info, const std::string& key) const {
        const double value = number(info, key);
        if (!(std::abs(value) < 1 << 24)) fail("volume_data_3d_info." + key + " is impossible");
        return static_cast<int>(std::lround(value));
    }
    static std::string at(const char* key, int i) { return std::string(key) + "[" + std::to_string(i) + "]"; }

    DensityMap readMapBlock(const MsgpackValue& block) const {
        const MsgpackValue info = *category(block, "volume_data_3d_info");
        MapBox box;
        for (int i = 0; i < 3; ++i) {
            box.axes[static_cast<std::size_t>(i)] = whole(info, at("axis_order", i)) + 1;
            box.cell.lengths[i] = number(info, at("spacegroup_cell_size", i));
            box.cell.angles[i] = number(info, at("spacegroup_cell_angles", i));
        }
        std::array<int, 3> sorted = box.axes;
        std::sort(sorted.begin(), sorted.end());
        if (sorted != std::array<int, 3>{1, 2, 3}) fail("its axis_order is not an order of three axes");
        for (int i = 0; i < 3; ++i) {
            const int axis = box.axes[static_cast<std::size_t>(i)] - 1;
            const double share = number(info, at("dimensions", i));
            box.size[axis] = whole(info, at("sample_count", i));
            const double intervals = share > 0 ? box.size[axis] / share : 0;
            if (!(intervals >= 1 && intervals < 1 << 24)) fail("its dimensions are impossible");
            box.intervals[axis] = static_cast<int>(std::lround(intervals));
            const double start = number(info, at("origin", i)) * box.intervals[axis];
            if (!(std::abs(start) < 1 << 24)) fail("its origin is impossible");
            box.start[axis] = static_cast<int>(std::lround(start));
        }
        box.spaceGroup = whole(info, "spacegroup_number");
        // A server returns boxes for crystals too: symmetry is already applied.
        box.values = readValues(*category(block, "volume_data_3d"), box);
        return completed(name_, "density-server", std::move(box), limits_);
    }

    std::vector<float> readValues(const MsgpackValue& data, const MapBox& box) const {
        const auto column = named(data, "columns", "values");
        if (!column) fail("volume_data_3d has no values");
        // Runs of equal values are packed: as much as a compressed file may be.
        constexpr std::uint64_t kMostRatio = 100, kAnyNodes = std::uint64_t{16} << 20;
        const std::size_t nodes = heldNodes(name_, box.size, limits_, std::max(kAnyNodes, kMostRatio * bytes_.size()));
        std::vector<float> values;
        try {
            BcifColumn packed(*column, nodes, 16);
            values.resize(nodes);
            const std::array<std::size_t, 3> inBox{1, static_cast<std::size_t>(box.size.x),
                                                   static_cast<std::size_t>(box.size.x) * box.size.y};
            const auto stride = [&](std::size_t i) { return inBox[static_cast<std::size_t>(box.axes[i] - 1)]; };
            const auto count = [&](std::size_t i) { return box.size[box.axes[i] - 1]; };
            for (int s = 0; s < count(2); ++s)
                for (int r = 0; r < count(1); ++r)
                    for (int c = 0; c < count(0); ++c)
                        values[s * stride(2) + r * stride(1) + c * stride(0)] =
                            static_cast<float>(packed.next().number().value_or(NAN));
        } catch (const PackedFault& fault) {
            fail("volume_data_3d.values: " + printable(fault.what(), 200));
        }
        return values;
    }

    const std::string& name_;
    std::string_view bytes_;
    MapLimits limits_;
};

}  // namespace

DensityMap readDensityServer(const std::string& name, std::string_view bytes, const MapLimits& limits) {
    return DensityServerReader(name, bytes, limits).read();
}

}  // namespace nacre
