#include "app/android/opened_files.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <vector>

#include "engine/error.h"

namespace nacre::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestName = 100;

/// A name without folders, special characters and leading dots.
std::string tameName(const std::string& name) {
    std::string tame;
    for (const char c : name.substr(name.find_last_of("/:") + 1)) {
        const bool plain = std::isalnum(static_cast<unsigned char>(c)) ||
                           std::string_view("-_.+() ").find(c) != std::string_view::npos;
        tame += plain ? c : '_';
    }
    tame.erase(0, std::min(tame.find_first_not_of(". "), tame.size()));
    // Keeps the extension, which decides the format.
    if (tame.size() > kLongestName) tame.erase(0, tame.size() - kLongestName);
    return tame.empty() ? "structure" : tame;
}

/// Each copy has its own folder with an increasing number.
std::vector<std::uint64_t> numbersIn(const std::string& folder) {
    std::vector<std::uint64_t> numbers;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        const std::string name = entry.path().filename().string();
        std::uint64_t number = 0;
        const auto [end, fault] = std::from_chars(name.data(), name.data() + name.size(), number);
        if (fault == std::errc() && end == name.data() + name.size()) numbers.push_back(number);
    }
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

}  // namespace

std::string OpenedFiles::keep(const std::string& name, const ReadBytes& read) const {
    std::error_code error;
    fs::create_directories(folder_, error);
    const std::vector<std::uint64_t> before = numbersIn(folder_);
    fs::path own;
    for (std::uint64_t number = before.empty() ? 1 : before.back() + 1; !error; ++number) {
        own = fs::path(folder_) / std::to_string(number);
        if (fs::create_directory(own, error)) break;
    }
    if (error) throw Error("cannot open file", name, error.message());
    const fs::path path = own / tameName(name);
    try {
        std::ofstream file(path, std::ios::binary);
        std::vector<char> buffer(1 << 16);
        std::uint64_t total = 0;
        while (const std::size_t count = read(buffer.data(), buffer.size())) {
            total += count;
            if (total > kMostBytes) throw Error("cannot open file", name, "it has more than 512 MB");
            file.write(buffer.data(), static_cast<std::streamsize>(count));
        }
        file.close();
        if (!file) throw Error("cannot open file", name, "it cannot be copied (is the device full?)");
    } catch (...) {
        fs::remove_all(own, error);
        throw;
    }
    trim();
    return path.string();
}

void OpenedFiles::trim() const {
    const std::vector<std::uint64_t> numbers = numbersIn(folder_);
    std::error_code ignored;
    for (std::size_t i = 0; i + kMostFiles < numbers.size(); ++i)
        fs::remove_all(fs::path(folder_) / std::to_string(numbers[i]), ignored);
}

}  // namespace nacre::app
