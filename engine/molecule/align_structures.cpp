#include "engine/molecule/align_structures.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace nacre {
namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// The distance at which a pair scores one half, Å.
double halfDistance(std::size_t length) {
    constexpr double kLeast = 0.5;
    return length > 21 ? std::max(kLeast, 1.24 * std::cbrt(static_cast<double>(length) - 15) - 1.8) : kLeast;
}

class Aligner {
public:
    Aligner(std::span<const TraceResidue> moving, std::span<const TraceResidue> fixed)
        : moving_(moving),
          fixed_(fixed),
          shorter_(std::min(moving.size(), fixed.size())),
          half_(std::max(halfDistance(shorter_), 1.0)),
          near_(std::clamp(half_, 4.5, 8.0)),
          scores_(moving.size() * fixed.size()),
          best_((moving.size() + 1) * (fixed.size() + 1)),
          paired_((moving.size() + 1) * (fixed.size() + 1)) {}

    StructureAlignment run() {
        const Pairs gapless = bestShift();
        improve(gapless);
        scoreByFold(0);
        improve(aligned(-1));
        if (!top_.empty()) {
            scoreByDistance(topMotion_);
            scoreByFold(0.5);
            improve(aligned(-1));
        }
        improve(byFragments(std::min<std::size_t>(20, shorter_ / 3)));
        improve(byFragments(std::min<std::size_t>(100, shorter_ / 2)));
        return result();
    }

private:
    // --- superposition

    double squareAfter(const Superposition& motion, const std::pair<std::uint32_t, std::uint32_t>& pair) const {
        const glm::dvec3 d = motion(moving_[pair.first].place) - fixed_[pair.second].place;
        return glm::dot(d, d);
    }

    Superposition superposed(const Pairs& pairs) {
        from_.clear(), to_.clear();
        for (const auto& [i, j] : pairs) from_.push_back(moving_[i].place), to_.push_back(fixed_[j].place);
        return superpose(to_, from_);
    }

    /// Sum over pairs of 1 / (1 + (d / half)^2).
    double computeScore(const Pairs& pairs, const Superposition& motion, double half) const {
        double sum = 0;
        for (const auto& pair : pairs) sum += 1 / (1 + squareAfter(motion, pair) / (half * half));
        return sum;
    }

    /// Pairs within a distance; if these are fewer than three, the distance grows.
    Pairs within(const Pairs& pairs, const Superposition& motion, double distance) const {
        Pairs close;
        for (; close.size() < 3; distance += 0.5) {
            close.clear();
            for (const auto& pair : pairs)
                if (squareAfter(motion, pair) <= distance * distance) close.push_back(pair);
        }
        return close;
    }

    /// The best-scoring superposition found from fragments of the alignment, each refined by the pairs that come near.
    /// @param step  between the starts of fragments
    std::pair<double, Superposition> bestMotion(const Pairs& pairs, std::size_t step, double half) {
        constexpr int kMostTurns = 20;
        constexpr std::size_t kShortest = 4, kHalvings = 6;
        std::pair<double, Superposition> best{-1, {}};
        const auto take = [&](const Superposition& motion) {
            if (const double score = computeScore(pairs, motion, half); score > best.first) best = {score, motion};
        };
        std::size_t length = pairs.size();
        for (std::size_t halving = 0; halving < kHalvings; ++halving) {
            for (std::size_t at = 0; at + length <= pairs.size(); at += step) {
                Pairs chosen(pairs.begin() + static_cast<std::ptrdiff_t>(at),
                             pairs.begin() + static_cast<std::ptrdiff_t>(at + length));
                Superposition motion = superposed(chosen);
                take(motion);
                double reach = near_ - 1;
                for (int turn = 0; turn < kMostTurns; ++turn, reach = near_ + 1) {
                    Pairs next = within(pairs, motion, reach);
                    if (turn > 0 && next == chosen) break;
                    chosen = std::move(next);
                    motion = superposed(chosen);
                    take(motion);
                }
            }
            if (length <= kShortest) break;
            length = std::max(length / 2, std::min(kShortest, pairs.size()));
        }
        return best;
    }

    // --- dynamic programming

    double& scoreAt(std::size_t i, std::size_t j) { return scores_[i * fixed_.size() + j]; }

    void scoreByDistance(const Superposition& motion) {
        for (std::size_t i = 0; i < moving_.size(); ++i) {
            const glm::dvec3 place = motion(moving_[i].place);
            for (std::size_t j = 0; j < fixed_.size(); ++j) {
                const glm::dvec3 d = place - fixed_[j].place;
                scoreAt(i, j) = 1 / (1 + glm::dot(d, d) / (half_ * half_));
            }
        }
    }

    /// Equal secondary structure scores one. @param weight  of it relative to existing scores; 0: replaces them
    void scoreByFold(double weight) {
        for (std::size_t i = 0; i < moving_.size(); ++i)
            for (std::size_t j = 0; j < fixed_.size(); ++j) {
                const double same = moving_[i].fold == fixed_[j].fold ? 1 : 0;
                scoreAt(i, j) = weight > 0 ? scoreAt(i, j) + weight * same : same;
            }
    }

    /// The alignment with the largest sum of scores. Opening a gap has a cost, extending it has none; ends are free.
    Pairs aligned(double gap) {
        const std::size_t rows = moving_.size() + 1, columns = fixed_.size() + 1;
        for (std::size_t i = 0; i < rows; ++i) best_[i * columns] = 0, paired_[i * columns] = false;
        for (std::size_t j = 0; j < columns; ++j) best_[j] = 0, paired_[j] = false;
        for (std::size_t i = 1; i < rows; ++i)
            for (std::size_t j = 1; j < columns; ++j) {
                const std::size_t here = i * columns + j, up = here - columns;
                const double pair = best_[up - 1] + scoreAt(i - 1, j - 1);
                const double skipMoving = best_[up] + (paired_[up] ? gap : 0);
                const double skipFixed = best_[here - 1] + (paired_[here - 1] ? gap : 0);
                paired_[here] = pair >= std::max(skipMoving, skipFixed);
                best_[here] = std::max({pair, skipMoving, skipFixed});
            }
        Pairs pairs;
        for (std::size_t i = rows - 1, j = columns - 1; i > 0 && j > 0;) {
            const std::size_t here = i * columns + j, up = here - columns;
            if (paired_[here]) {
                pairs.emplace_back(static_cast<std::uint32_t>(--i), static_cast<std::uint32_t>(--j));
            } else {
                const double skipMoving = best_[up] + (paired_[up] ? gap : 0);
                const double skipFixed = best_[here - 1] + (paired_[here - 1] ? gap : 0);
                --(skipFixed >= skipMoving ? j : i);
            }
        }
        std::ranges::reverse(pairs);
        return pairs;
    }

    // --- beginnings

    Pairs pairShifted(std::ptrdiff_t shift, std::size_t from = 0, std::size_t length = ~std::size_t{0}) const {
        Pairs pairs;
        for (std::size_t i = from; i < moving_.size() && i - from < length; ++i) {
            const std::ptrdiff_t j = static_cast<std::ptrdiff_t>(i) + shift;
            if (j >= 0 && j < static_cast<std::ptrdiff_t>(fixed_.size()))
                pairs.emplace_back(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
        }
        return pairs;
    }

    /// A quick lower bound of bestMotion(): from all pairs, then twice from those that come near.
    double quickScore(const Pairs& pairs) {
        Superposition motion = superposed(pairs);
        double best = computeScore(pairs, motion, half_);
        for (int turn = 0; turn < 2; ++turn) {
            motion = superposed(within(pairs, motion, near_));
            best = std::max(best, computeScore(pairs, motion, half_));
        }
        return best;
    }

    Pairs bestShift() {
        const auto least = static_cast<std::ptrdiff_t>(std::max(shorter_ / 2, kFewestAligned));
        const auto low = least - static_cast<std::ptrdiff_t>(moving_.size());
        const auto high = static_cast<std::ptrdiff_t>(fixed_.size()) - least;
        Pairs best;
        double most = -1;
        for (std::ptrdiff_t shift = low; shift <= high; ++shift) {
            Pairs pairs = pairShifted(shift);
            if (const double score = quickScore(pairs); score > most) most = score, best = std::move(pairs);
        }
        return best;
    }

    /// The best alignment by distance after superposing one fragment on another.
    Pairs byFragments(std::size_t length) {
        length = std::max(length, kFewestAligned);
        const auto chooseStep = [&](std::size_t count) {
            const std::size_t usual = count > 250 ? 45 : count > 200 ? 35 : count > 150 ? 25 : 15;
            return std::min(usual, std::max<std::size_t>(shorter_ / 3, 1));
        };
        const std::size_t movingStep = chooseStep(moving_.size()), fixedStep = chooseStep(fixed_.size());
        Pairs best;
        double most = -1;
        for (std::size_t i = 0; i + length <= moving_.size(); i += movingStep)
            for (std::size_t j = 0; j + length <= fixed_.size(); j += fixedStep) {
                const auto shift = static_cast<std::ptrdiff_t>(j) - static_cast<std::ptrdiff_t>(i);
                scoreByDistance(superposed(pairShifted(shift, i, length)));
                Pairs pairs = aligned(0);
                if (pairs.size() < 3) continue;
                if (const double score = quickScore(pairs); score > most) most = score, best = std::move(pairs);
            }
        return best;
    }

    // --- improvement

    /// Superposes and aligns in turn until nothing changes; keeps the best alignment of all.
    void improve(Pairs pairs) {
        constexpr int kMostTurns = 30;
        constexpr std::size_t kCoarse = 40;
        if (pairs.size() < 3) return;
        const Superposition start = bestMotion(pairs, kCoarse, half_).second;
        take(pairs, start);
        for (const double gap : {-0.6, 0.0}) {
            Superposition motion = start;
            double before = 0;
            for (int turn = 0; turn < kMostTurns; ++turn) {
                scoreByDistance(motion);
                pairs = aligned(gap);
                if (pairs.size() < 3) break;
                double score = 0;
                std::tie(score, motion) = bestMotion(pairs, kCoarse, half_);
                take(pairs, motion);
                if (std::abs(score - before) < 1e-6) break;
                before = score;
            }
        }
    }

    void take(const Pairs& pairs, const Superposition& motion) {
        if (const double score = computeScore(pairs, motion, half_); score > topScore_)
            topScore_ = score, top_ = pairs, topMotion_ = motion;
    }

    StructureAlignment result() {
        StructureAlignment found;
        if (top_.empty()) return found;
        found.motion = bestMotion(top_, 1, half_).second;
        // Residues farther apart score nothing.
        const double reach = 1.5 * std::pow(static_cast<double>(shorter_), 0.3) + 3.5;
        found.pairs = within(top_, found.motion, reach);
        const auto normalised = [&](std::size_t length) {
            const double half = halfDistance(length);
            return bestMotion(found.pairs, 1, half).first / static_cast<double>(length);
        };
        found.scoreByMoving = normalised(moving_.size());
        found.scoreByFixed = normalised(fixed_.size());
        found.motion.rmsd = superposed(found.pairs).rmsd;
        return found;
    }

    std::span<const TraceResidue> moving_, fixed_;
    std::size_t shorter_;
    double half_, near_;  // Å: distance of a score of one half; within it, pairs are superposed
    std::vector<double> scores_, best_;
    std::vector<char> paired_;
    std::vector<glm::dvec3> from_, to_;
    Pairs top_;
    Superposition topMotion_;
    double topScore_ = -1;
};

}  // namespace

StructureAlignment alignStructures(std::span<const TraceResidue> moving, std::span<const TraceResidue> fixed) {
    return Aligner(moving, fixed).run();
}

}  // namespace nacre
