#include "engine/molecule/nearest_word.h"

#include <algorithm>
#include <vector>

namespace nacre {
namespace {

constexpr std::size_t kLongestWord = 40;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Number of edits between two words, by F. J. Damerau's four operations; edits no letter twice.
std::size_t edits(std::string_view a, std::string_view b) {
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
    for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i)
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = lower(a[i - 1]) == lower(b[j - 1]);
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (same ? 0 : 1)});
            if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]))
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    return d[a.size()][b.size()];
}

}  // namespace

std::string nearestWord(std::string_view word, std::span<const std::string> words) {
    if (word.size() <= 2 || word.size() > kLongestWord) return {};
    std::size_t least = word.size() <= 4 ? 1 : 2;
    std::string nearest;
    for (const std::string& candidate : words) {
        const std::size_t distance = edits(word, candidate);
        if (distance > least || (distance == least && !nearest.empty())) continue;
        least = distance;
        nearest = candidate;
    }
    return nearest;
}

std::string suggestion(std::string_view word, std::span<const std::string> words) {
    const std::string nearest = nearestWord(word, words);
    return nearest.empty() ? nearest : " (did you mean '" + nearest + "'?)";
}

}  // namespace nacre
