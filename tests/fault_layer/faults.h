#pragma once
// A Vulkan layer that makes calls fail, for tests. It stands above the validation layer, so that a call that it fails
// never happened for whoever is below: what validation says then, the engine did.
//
// In the test's own process these functions steer it; in another one the environment does, read when the instance is
// made: NACRE_FAULT=FUNCTION:NUMBER:RESULT (`*` for any call that may run out of memory; NUMBER+ for that call and all
// behind it; `DEVICE_LOST`, ... without VK_ERROR_), NACRE_FAULT_DATA=1 for a device that offers VK_EXT_device_fault,
// and NACRE_FAULT_COUNTS=1 for a line per function with the number of its calls. When the instance goes, such a process
// prints these, what made from it is left, and whether the fault never came, on standard error.
//
// For one instance with one device at a time. Calls may come from several threads; lists are read when those are done.

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace nacre::faults {

/// A call that the layer saw and that may run out of memory.
struct Call {
    std::string function;  ///< "vkCreateBuffer"
    std::uint64_t site;    ///< of the program: a hash of the addresses that it was called from
    std::thread::id thread;
};

/// Forgets calls, faults and messages, and counts from 1 again.
void reset();

/// Lets the number-th call from now on of a function fail; "*": of all that may run out of memory.
/// After VK_ERROR_DEVICE_LOST everything that can tells the same until another device is made. Acquiring and presenting
/// with VK_SUBOPTIMAL_KHR is done, and says so; likewise a fence is asked for its status, with VK_NOT_READY.
void fail(const std::string& function, std::uint64_t number, VkResult result);
/// The number-th call and all that follow fail, until reset().
void failFrom(const std::string& function, std::uint64_t number, VkResult result);
/// Each place of the program that makes such calls finds that its first one fails, until reset().
void failEverySite(const std::string& function, VkResult result);
/// Faults that came to pass since reset().
std::uint64_t struck();

/// A device that offers VK_EXT_device_fault, and made-up data when it is lost. Takes hold of the next instance.
void offerFaultData(bool offered);

/// Devices that are made from now on do not offer these extensions, whatever they have.
void hideExtensions(std::set<std::string> names);
/// What surfaces say that their window measures from now on, in pixels; 0 and 0: what they know.
void setWindowSize(std::uint32_t width, std::uint32_t height);

/// A display by a clock of its own, for a window that nobody sees. At each interval it takes the next image that was
/// presented, shows it a number of intervals later, and is done with it when it takes another one.
struct Display {
    int version = 1;  ///< of VK_KHR_present_wait, for devices that are made from now on
    double interval = 1.0 / 64;
    int latency = 0;              ///< intervals from taking an image to showing it
    bool shows = true;            ///< a window that is hidden shows nothing more
    bool surfaceSupports = true;  ///< the second version asks surfaces
};
void setDisplay(const std::optional<Display>& display);
/// The display's time in seconds. It goes on while the program waits for it.
double displayTime();
/// The program works for so long.
void passTime(double seconds);

/// A present with its number. The layer ends the program if numbers do not rise.
struct Present {
    std::uint64_t number = 0;
    double at = 0, taken = 0, shown = 0;  ///< seconds
};
/// Since setDisplay(), those of former swapchains included.
const std::vector<Present>& presents();

/// Calls that may run out of memory since reset(), in their order.
const std::vector<Call>& calls();
/// How often a function was called since reset(): those that may fail in whatever way.
std::uint64_t count(const std::string& function);

/// Objects that were made and not destroyed so far, by kind: "Buffer". Instances included.
std::map<std::string, std::int64_t> alive();
/// What the validation layer said since reset(), until the instance's very end.
const std::vector<std::string>& messages();

}  // namespace nacre::faults
