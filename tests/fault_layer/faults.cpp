#include "tests/fault_layer/faults.h"

#include <execinfo.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <set>
#include <sstream>

#include "tests/fault_layer/state.h"

namespace nacre::faults {
namespace {

struct Rule {
    std::string function;
    std::uint64_t first = 0, last = 0;  // 0 and 0: once at every site
    VkResult result = VK_SUCCESS;
    std::set<std::pair<std::string, std::uint64_t>> sites = {};  // that had it

    bool concerns(const char* called, bool runsOut) const { return function == called || (function == "*" && runsOut); }
    bool strikes(std::uint64_t number, const char* called, std::uint64_t site) {
        return last == 0 ? sites.emplace(called, site).second : number >= first && number <= last;
    }
};

struct State {
    std::vector<Rule> rules;
    std::uint64_t struck = 0;
    bool lost = false, faultData = false, fromEnvironment = false, printsCounts = false;
    std::set<std::string> hidden;
    VkExtent2D window{0, 0};
    std::vector<Call> calls;
    std::map<std::string, std::uint64_t> counts;
    std::map<std::string, std::int64_t> alive;
    std::vector<std::string> messages;
};

State& state() {
    static State state;
    return state;
}

/// Held by whatever reads or changes the state: pipelines are made on a thread of their own, too. Again by the same
/// thread, as calls come from within calls.
std::lock_guard<std::recursive_mutex> hold() {
    static std::recursive_mutex turn;
    return std::lock_guard(turn);
}

/// FNV-1a over the return addresses. Of one process: addresses change from one to the next.
std::uint64_t callSite() {
    std::array<void*, 24> frames{};
    const int count = backtrace(frames.data(), static_cast<int>(frames.size()));
    std::uint64_t hash = 0xcbf29ce484222325ull;
    for (int i = 0; i < count; ++i)
        hash = (hash ^ reinterpret_cast<std::uint64_t>(frames[static_cast<std::size_t>(i)])) * 0x100000001b3ull;
    return hash;
}

VkResult resultNamed(const std::string& name) {
    const std::pair<const char*, VkResult> results[] = {{"OUT_OF_HOST_MEMORY", VK_ERROR_OUT_OF_HOST_MEMORY},
                                                        {"OUT_OF_DEVICE_MEMORY", VK_ERROR_OUT_OF_DEVICE_MEMORY},
                                                        {"INITIALIZATION_FAILED", VK_ERROR_INITIALIZATION_FAILED},
                                                        {"DEVICE_LOST", VK_ERROR_DEVICE_LOST},
                                                        {"SURFACE_LOST_KHR", VK_ERROR_SURFACE_LOST_KHR},
                                                        {"OUT_OF_DATE_KHR", VK_ERROR_OUT_OF_DATE_KHR}};
    for (const auto& [known, result] : results)
        if (name == known) return result;
    std::fprintf(stderr, "fault layer: no result '%s'\n", name.c_str());
    std::abort();
}

}  // namespace

void readEnvironment() {
    const auto held = hold();
    State& s = state();
    const char* data = std::getenv("NACRE_FAULT_DATA");
    if (data && *data == '1') s.faultData = true;
    if (std::getenv("NACRE_FAULT_COUNTS")) s.fromEnvironment = s.printsCounts = true;
    const char* fault = std::getenv("NACRE_FAULT");
    if (!fault || !s.rules.empty()) return;
    s.fromEnvironment = true;
    std::istringstream faults(fault);
    for (std::string text; std::getline(faults, text, ';');) {
        const std::size_t first = text.find(':'), last = text.rfind(':');
        if (first == last) continue;  // watches alone
        const std::uint64_t number = std::stoull(text.substr(first + 1, last - first - 1));
        const std::uint64_t end = text[last - 1] == '+' ? ~std::uint64_t{0} : number;
        s.rules.push_back({text.substr(0, first), number, end, resultNamed(text.substr(last + 1))});
    }
}

std::optional<VkResult> verdict(const char* function, bool runsOut, bool canBeLost) {
    const auto held = hold();
    State& s = state();
    if (s.lost && canBeLost) return VK_ERROR_DEVICE_LOST;
    ++s.counts[function];
    const std::uint64_t site = callSite();
    if (runsOut) {
        ++s.counts["*"];
        s.calls.push_back({function, site, std::this_thread::get_id()});
    }
    for (Rule& rule : s.rules) {
        if (!rule.concerns(function, runsOut) || !rule.strikes(s.counts[rule.function], function, site)) continue;
        ++s.struck;
        if (rule.result == VK_ERROR_DEVICE_LOST) {
            letFinish();
            s.lost = true;
        }
        return rule.result;
    }
    return std::nullopt;
}

void made(const std::string& kind, std::int64_t count) {
    const auto held = hold();
    state().alive[kind] += count;
}

void newDevice() {
    const auto held = hold();
    state().lost = false;
}

bool offersFaultData() { return state().faultData; }
bool hides(const std::string& extension) { return state().hidden.contains(extension); }
VkExtent2D windowSize() { return state().window; }

void heard(const char* message) {
    const auto held = hold();
    state().messages.emplace_back(message ? message : "");
    if (state().fromEnvironment) std::fprintf(stderr, "fault layer: validation: %s\n", message ? message : "");
}

void instanceGone() {
    const auto held = hold();
    if (!state().fromEnvironment) return;
    if (!state().rules.empty() && state().struck == 0) std::fprintf(stderr, "fault layer: there was no such call\n");
    for (const auto& [kind, count] : state().alive)
        if (count != 0)
            std::fprintf(stderr, "fault layer: %lld x %s left\n", static_cast<long long>(count), kind.c_str());
    if (!state().printsCounts) return;
    for (const auto& [function, count] : state().counts)
        std::fprintf(stderr, "fault layer: called %s %llu\n", function.c_str(), static_cast<unsigned long long>(count));
}

void reset() {
    const auto held = hold();
    State& s = state();
    s.rules.clear();
    s.struck = 0;
    s.calls.clear();
    s.counts.clear();
    s.messages.clear();
}

void fail(const std::string& function, std::uint64_t number, VkResult result) {
    const auto held = hold();
    const std::uint64_t at = state().counts[function] + number;
    state().rules.push_back({function, at, at, result});
}

void failFrom(const std::string& function, std::uint64_t number, VkResult result) {
    const auto held = hold();
    state().rules.push_back({function, state().counts[function] + number, ~std::uint64_t{0}, result});
}

void failEverySite(const std::string& function, VkResult result) {
    const auto held = hold();
    state().rules.push_back({function, 0, 0, result});
}

std::uint64_t struck() {
    const auto held = hold();
    return state().struck;
}

void offerFaultData(bool offered) { state().faultData = offered; }
void hideExtensions(std::set<std::string> names) { state().hidden = std::move(names); }
void setWindowSize(std::uint32_t width, std::uint32_t height) { state().window = {width, height}; }
const std::vector<Call>& calls() { return state().calls; }
std::uint64_t count(const std::string& function) {
    const auto held = hold();
    return state().counts[function];
}

const std::vector<std::string>& messages() { return state().messages; }

std::map<std::string, std::int64_t> alive() {
    const auto held = hold();
    std::map<std::string, std::int64_t> alive = state().alive;
    std::erase_if(alive, [](const auto& entry) { return entry.second == 0; });
    return alive;
}

}  // namespace nacre::faults
