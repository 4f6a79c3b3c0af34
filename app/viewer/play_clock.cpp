#include "app/viewer/play_clock.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>

namespace nacre::app {
namespace {

constexpr double kRates[] = {0.5, 1, 2, 5, 10, 15, 20, 24, 30, 60, 120};

}  // namespace

void PlayClock::begin(std::size_t frames, std::size_t frame, double rate) {
    const PlayOrder order = order_;
    *this = {};
    order_ = order;
    frames_ = frames;
    frame_ = frame;
    rate_ = rate;
}

void PlayClock::setFrames(std::size_t frames) {
    if (frames == frames_) return;
    frames_ = frames;
    frame_ = std::min(frame_, frames - std::min<std::size_t>(frames, 1));
    playing_ = false;
}

void PlayClock::play(double now) {
    playing_ = frames_ > 1;
    due_ = now;
    if (order_ == PlayOrder::once && frame_ + 1 >= frames_ && playing_) frame_ = frames_ - 1, back_ = true;
}

std::optional<std::size_t> PlayClock::next() const {
    if (frames_ < 2) return std::nullopt;
    const bool last = frame_ + 1 >= frames_;
    switch (order_) {
        case PlayOrder::round:
            return last ? 0 : frame_ + 1;
        case PlayOrder::backAndForth:
            return (back_ && frame_ > 0) || last ? frame_ - 1 : frame_ + 1;
        default:
            if (last && back_) return 0;
            return last ? std::nullopt : std::optional(frame_ + 1);
    }
}

void PlayClock::shown(std::size_t frame, double now) {
    if (order_ == PlayOrder::backAndForth && frame != frame_) back_ = frame < frame_;
    if (order_ == PlayOrder::once) back_ = false;
    frame_ = frame;
    // One that was late does not make the next come sooner than they would.
    const double interval = 1 / rate_;
    due_ = std::max(due_ + interval, now);
}

std::string rateText(double rate) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%g frame%s per second", rate, rate == 1 ? "" : "s");
    return text.data();
}

void PlayClock::setRate(double rate) { rate_ = std::clamp(rate, kSlowest, kFastest); }

void PlayClock::stepRate(int way) {
    const auto end = std::end(kRates);
    if (way > 0) {
        const auto faster = std::upper_bound(std::begin(kRates), end, rate_ * 1.001);
        if (faster != end) rate_ = *faster;
    } else {
        const auto slower = std::lower_bound(std::begin(kRates), end, rate_ * 0.999);
        if (slower != std::begin(kRates)) rate_ = *(slower - 1);
    }
}

}  // namespace nacre::app
