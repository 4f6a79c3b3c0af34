#pragma once
// The values of a density map. Copies of a map share them.

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace nacre {

class MapValues {
public:
    MapValues() = default;
    MapValues(std::vector<float> values) : values_(std::make_shared<std::vector<float>>(std::move(values))) {}

    const std::vector<float>& all() const {
        static const std::vector<float> none;
        return values_ ? *values_ : none;
    }
    operator const std::vector<float>&() const { return all(); }
    const float* data() const { return all().data(); }
    std::size_t size() const { return all().size(); }
    bool empty() const { return all().empty(); }
    float operator[](std::size_t i) const { return (*values_)[i]; }
    auto begin() const { return all().begin(); }
    auto end() const { return all().end(); }

    /// Values for writing; copies them first if others share them.
    std::vector<float>& change() {
        if (values_.use_count() != 1) values_ = std::make_shared<std::vector<float>>(all());
        return *values_;
    }

private:
    std::shared_ptr<std::vector<float>> values_;
};

}  // namespace nacre
