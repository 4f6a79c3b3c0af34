#pragma once
// Helpers for drawing on the host by several threads: from near to far, each thread a band of rows.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/lists/screen_view.h"

namespace nacre {

/// @param near  Z, or depth with the default ScreenView
template <std::uint32_t kDepths>
std::uint32_t depthStep(const ScreenView& view, float near) {
    const float share = (near - view.nearest) / view.range;
    return static_cast<std::uint32_t>(std::min(std::max(share * kDepths, 0.0f), kDepths - 1.0f));
}

/// Indices of things from near to far, bucketed into this many depths. Equal depths keep their order.
/// @tparam T  has `near`, Z
template <std::uint32_t kDepths, typename T>
void orderNearFirst(const ScreenView& view, const std::vector<T>& things, std::vector<std::uint32_t>& order) {
    const auto depthIndex = [&](const T& thing) { return depthStep<kDepths>(view, thing.near); };
    std::array<std::uint32_t, kDepths + 1> at{};
    for (const T& thing : things) ++at[depthIndex(thing) + 1];
    for (std::uint32_t i = 1; i <= kDepths; ++i) at[i] += at[i - 1];
    order.resize(things.size());
    for (std::uint32_t i = 0; i < things.size(); ++i) order[at[depthIndex(things[i])]++] = i;
}

/// The things themselves in this order, from several lists: for lists larger than caches.
template <std::uint32_t kDepths, typename T>
void sortNearFirst(const ScreenView& view, std::span<std::vector<T>> lists, std::vector<T>& sorted) {
    const auto depthIndex = [&](const T& thing) { return depthStep<kDepths>(view, thing.near); };
    std::array<std::uint32_t, kDepths + 1> at{};
    for (const std::vector<T>& things : lists)
        for (const T& thing : things) ++at[depthIndex(thing) + 1];
    for (std::uint32_t i = 1; i <= kDepths; ++i) at[i] += at[i - 1];
    sorted.resize(at[kDepths]);
    for (const std::vector<T>& things : lists)
        for (const T& thing : things) sorted[at[depthIndex(thing)]++] = thing;
}

/// Rows of a picture; end exclusive.
struct RowBand {
    std::uint32_t first = 0, end = 0;
};

/// Bands of rows for threads, with equal numbers of things. @param findRow  row of a thing, below `rows`
template <typename T, typename FindRow>
void partRows(std::uint32_t rows, std::size_t parts, const std::vector<T>& things, const FindRow& findRow,
              std::vector<std::uint32_t>& inRow, std::vector<RowBand>& bands) {
    bands.clear();
    inRow.assign(rows, 0);
    if (parts > 1)
        for (const T& thing : things) ++inRow[findRow(thing)];
    std::size_t before = 0;
    std::uint32_t first = 0;
    for (std::uint32_t row = 0; row < rows && bands.size() + 1 < parts; ++row) {
        before += inRow[row];
        if (before * parts < things.size() * (bands.size() + 1)) continue;
        bands.push_back({first, row + 1});
        first = row + 1;
    }
    bands.push_back({first, rows});
}

}  // namespace nacre
