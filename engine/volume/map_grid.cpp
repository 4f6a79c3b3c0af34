#include "engine/volume/map_grid.h"

#include <algorithm>
#include <cmath>

namespace nacre {
namespace {

int wrapped(long at, int count) {
    const long rest = at % count;
    return static_cast<int>(rest < 0 ? rest + count : rest);
}

/// Replaces infinities by NaN. @throws Error if no value is a number
void forgetNonNumbers(std::vector<float>& values, DensityMap& map) {
    std::size_t count = 0;
    for (float& value : values)
        if (!std::isfinite(value)) value = kUnknownDensity, ++count;
    if (count == values.size()) cannotReadMap(map.name, "none of its values is a number");
    if (count > 0)
        map.warnings.push_back(std::to_string(count) + " of the " + std::to_string(values.size()) +
                               " values of the map are not numbers: nothing is drawn there");
}

/// Copies the values of a box to their nodes in the cell. The first value of a node wins.
std::vector<float> wrappedIntoCell(const MapBox& box) {
    const glm::ivec3 n = box.intervals;
    std::vector<float> cell(static_cast<std::size_t>(n.x) * n.y * n.z, kUnknownDensity);
    const float* value = box.values.data();
    std::vector<int> xs(static_cast<std::size_t>(box.size.x));
    for (int x = 0; x < box.size.x; ++x) xs[static_cast<std::size_t>(x)] = wrapped(long{box.start.x} + x, n.x);
    for (int z = 0; z < box.size.z; ++z)
        for (int y = 0; y < box.size.y; ++y) {
            float* row = cell.data() + (static_cast<std::size_t>(wrapped(long{box.start.z} + z, n.z)) * n.y +
                                        wrapped(long{box.start.y} + y, n.y)) *
                                           n.x;
            for (const int x : xs) {
                if (std::isnan(row[x])) row[x] = *value;
                ++value;
            }
        }
    return cell;
}

/// Where an operation puts a node.
std::size_t movedNode(const NodeOperation& operation, const glm::ivec3& n, const glm::ivec3& node) {
    std::size_t there = 0;
    for (int i = 2; i >= 0; --i) {
        const auto& row = operation.rows[static_cast<std::size_t>(i)];
        const long to = long{row[0]} * node[0] + long{row[1]} * node[1] + long{row[2]} * node[2] +
                        operation.shift[static_cast<std::size_t>(i)];
        there = there * n[i] + static_cast<std::size_t>(wrapped(to, n[i]));
    }
    return there;
}

/// Fills unknown nodes of a cell from known nodes by symmetry. @returns whether every operation maps nodes to nodes
bool spread(std::vector<float>& cell, const glm::ivec3& n, const std::vector<SymmetryOperation>& operations) {
    std::vector<bool> known(cell.size());  // before any is filled
    for (std::size_t i = 0; i < cell.size(); ++i) known[i] = !std::isnan(cell[i]);
    if (std::find(known.begin(), known.end(), false) == known.end()) return true;
    std::vector<NodeOperation> onGrid;
    for (const SymmetryOperation& operation : operations) {
        if (operation.isIdentity()) continue;
        const std::optional<NodeOperation> op = onNodes(operation, n);
        if (!op) return false;
        onGrid.push_back(*op);
    }
    std::size_t at = 0;
    glm::ivec3 node;
    for (node.z = 0; node.z < n.z; ++node.z)
        for (node.y = 0; node.y < n.y; ++node.y)
            for (node.x = 0; node.x < n.x; ++node.x, ++at) {
                if (known[at]) continue;
                for (const NodeOperation& op : onGrid)
                    if (const std::size_t there = movedNode(op, n, node); known[there]) {
                        cell[at] = cell[there];
                        break;
                    }
            }
    return true;
}

bool contains(const std::string& text, std::initializer_list<const char*> words) {
    return std::any_of(words.begin(), words.end(),
                       [&](const char* word) { return text.find(word) != std::string::npos; });
}

/// Decides by the names that refinement programs and archives use.
bool isDifference(const std::string& path) {
    const std::string name = lowerCase(path.substr(path.find_last_of('/') + 1));
    return contains(name, {"diff", "fofc", "fo-fc", "fo_fc"}) && !contains(name, {"2fofc", "2fo-fc", "2fo_fc"});
}

DensityMap makeMap(const std::string& name, const char* format) {
    DensityMap map;
    map.name = name;
    map.format = format;
    map.difference = isDifference(name);
    return map;
}

}  // namespace

std::size_t checkedNodes(const std::string& name, const glm::ivec3& size, const MapLimits& limits,
                         std::uint64_t beside) {
    const auto text = [&] {
        return std::to_string(size.x) + " x " + std::to_string(size.y) + " x " + std::to_string(size.z);
    };
    if (size.x <= 0 || size.y <= 0 || size.z <= 0) cannotReadMap(name, "a grid of " + text() + " nodes");
    const double bytes = sizeof(float) * static_cast<double>(size.x) * size.y * size.z + static_cast<double>(beside);
    if (bytes > static_cast<double>(limits.maxBytes))
        cannotReadMap(name, "a grid of " + text() + " nodes takes " +
                                std::to_string(std::llround(std::min(bytes / 1048576, 1e15))) +
                                " MB, more than the limit of " + std::to_string(limits.maxBytes >> 20) + " MB");
    return static_cast<std::size_t>(size.x) * size.y * size.z;
}

std::size_t heldNodes(const std::string& name, const glm::ivec3& size, const MapLimits& limits, std::uint64_t held) {
    const std::size_t nodes = checkedNodes(name, size, limits);
    if (nodes > held)
        cannotReadMap(name, "it is cut short: its header announces " + std::to_string(nodes) +
                                " values, and it can hold " + std::to_string(held));
    return nodes;
}

void checkCell(const std::string& name, const MapBox& box, const MapLimits& limits) {
    if (!box.crystal) return;
    // In addition to the cell: the values of the box, and a bit per node.
    const double nodes = static_cast<double>(box.intervals.x) * box.intervals.y * box.intervals.z;
    const std::uint64_t beside =
        sizeof(float) * checkedNodes(name, box.size, limits) + static_cast<std::uint64_t>(std::min(nodes / 8, 1e18));
    checkedNodes(name, box.intervals, limits, beside);
    // Covers the file's values at all 192 places of the largest groups, and four times as many unknown nodes.
    constexpr double kAnyCell = 1 << 24, kMostTimes = 4 * 192;
    const double filled = kMostTimes * static_cast<double>(box.size.x) * box.size.y * box.size.z;
    if (nodes > std::max(kAnyCell, filled))
        cannotReadMap(name, "its cell of " + std::to_string(std::llround(nodes)) +
                                " nodes cannot be filled: the file holds " +
                                std::to_string(checkedNodes(name, box.size, limits)));
}

DensityMap completed(const std::string& name, const char* format, MapBox box, const MapLimits& limits,
                     const glm::dvec3* shift) {
    DensityMap map = makeMap(name, format);
    if (!box.cell.isValid()) cannotReadMap(name, "its cell has no volume");
    map.cell = box.cell;
    map.spaceGroup = box.spaceGroup;
    map.axes = box.axes;
    map.boxSize = box.size;
    map.boxStart = box.start;
    const glm::dmat3 edges = box.cell.edges();
    for (int i = 0; i < 3; ++i) map.step[i] = edges[i] / static_cast<double>(box.intervals[i]);
    map.periodic = box.crystal;
    if (box.crystal) {
        checkCell(name, box, limits);
        map.size = box.intervals;
        forgetNonNumbers(box.values, map);
        map.values = wrappedIntoCell(box);
        std::vector<float>().swap(box.values);
        const auto& operations = box.operations.empty() ? findOperations(box.spaceGroup, box.cell) : box.operations;
        if (!spread(map.values.change(), map.size, operations))
            map.warnings.push_back("the grid does not fit space group " + std::to_string(box.spaceGroup) +
                                   ": what the file holds is drawn without symmetry copies");
        map.statistics = computeStatistics(map.values);
        return map;
    }
    map.size = box.size;
    map.values = std::move(box.values);
    map.origin = shift ? *shift : map.step * glm::dvec3(box.start);
    forgetNonNumbers(map.values.change(), map);
    map.statistics = computeStatistics(map.values);
    return map;
}

DensityMap completed(const std::string& name, const char* format, const glm::ivec3& size, const glm::dvec3& origin,
                     const glm::dmat3& step, std::vector<float> values) {
    DensityMap map = makeMap(name, format);
    for (int i = 0; i < 3; ++i) {
        const double length = glm::length(step[i]);
        if (!(length > 0 && length < 1e6) || !std::isfinite(origin[i]))
            cannotReadMap(name, "the steps of its grid are not finite lengths");
        map.cell.lengths[i] = length * size[i];
        const glm::dvec3 &u = step[(i + 1) % 3], &v = step[(i + 2) % 3];
        const double cosine = glm::dot(u, v) / (glm::length(u) * glm::length(v));
        map.cell.angles[i] =
            std::abs(cosine) < 1e-9 ? 90 : std::acos(std::clamp(cosine, -1.0, 1.0)) * 57.29577951308232;
    }
    if (!map.cell.isValid()) cannotReadMap(name, "its grid has no volume");
    map.size = map.boxSize = size;
    map.origin = origin;
    map.step = step;
    map.values = std::move(values);
    forgetNonNumbers(map.values.change(), map);
    map.statistics = computeStatistics(map.values);
    return map;
}

DensityMap mapOfValues(const std::string& name, const glm::ivec3& size, const UnitCell& cell, const glm::dvec3& origin,
                       bool periodic, std::vector<float> values) {
    if (checkedNodes(name, size, {SIZE_MAX}) != values.size())
        cannotReadMap(name, "it has " + std::to_string(values.size()) + " values");
    MapBox box;
    box.cell = cell;
    box.intervals = box.size = size;
    box.crystal = periodic;
    box.spaceGroup = periodic ? 1 : 0;
    box.values = std::move(values);
    DensityMap map = completed(name, "values", std::move(box), {SIZE_MAX}, &origin);
    map.origin = origin;
    return map;
}

namespace {

std::string_view cutNumber(std::string_view& words) {
    const std::string_view word = words.substr(0, words.find(' '));
    words.remove_prefix(std::min(word.size() + 1, words.size()));
    return word;
}

}  // namespace

// A number takes at least a digit, and a blank or a sign.
GridValues::GridValues(const std::string& name, const glm::ivec3& size, const MapLimits& limits, std::string_view text,
                       std::size_t perNode)
    : name_(name),
      size_(size),
      text_(text),
      perNode_(perNode),
      values_(heldNodes(name, size, limits, (text.size() + 1) / 2 / perNode)) {}

void GridValues::read(std::uint64_t line) {
    const char *at = text_.data(), *end = at + text_.size();
    std::string apart;  // numbers of a word that touch
    std::string_view numbers;
    const auto next = [&]() -> std::string_view {
        if (!numbers.empty()) return cutNumber(numbers);
        while (at != end && isBlank(*at)) line += *at++ == '\n';
        const char* first = at;
        while (at != end && !isBlank(*at)) ++at;
        const std::string_view word(first, static_cast<std::size_t>(at - first));
        if (!mayTouch(word)) return word;
        apart = numbersApart(word);
        numbers = apart;
        return cutNumber(numbers);
    };
    std::size_t count = 0;
    for (int x = 0; x < size_.x; ++x)
        for (int y = 0; y < size_.y; ++y)
            for (int z = 0; z < size_.z; ++z, ++count)
                for (std::size_t i = 0; i < perNode_; ++i) {
                    const std::string_view word = next();
                    const auto parsed = parseNumber(word);
                    if (!parsed)
                        cannotReadMap(name_,
                                      word.empty() ? "it is cut short: " + std::to_string(count) + " of its " +
                                                         std::to_string(values_.size()) + " values are there"
                                                   : "expected a number instead of \"" + printable(word) + "\"",
                                      word.empty() ? 0 : line);
                    if (i == 0)
                        values_[(static_cast<std::size_t>(z) * size_.y + y) * size_.x + x] =
                            static_cast<float>(*parsed);
                }
}

}  // namespace nacre
