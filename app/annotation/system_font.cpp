#include "app/annotation/system_font.h"

#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <mutex>
#include <sstream>

namespace nacre::app {
namespace {

#if defined(__ANDROID__)
std::optional<FontFile> fontOfSystem(const std::vector<char32_t>& characters) {
    constexpr struct {
        char32_t from, to;
        const char* name;
    } kFonts[] = {{0x590, 0x600, "NotoSansHebrew-Regular.ttf"},
                  {0x600, 0x780, "NotoNaskhArabic-Regular.ttf"},
                  {0x900, 0x980, "NotoSansDevanagari-Regular.otf"},
                  {0xe00, 0xe80, "NotoSansThai-Regular.ttf"},
                  {0x2e80, 0x10000, "NotoSansCJK-Regular.ttc"}};
    for (const auto& font : kFonts)
        if (characters.front() >= font.from && characters.front() < font.to)
            return FontFile{std::string("/system/fonts/") + font.name};
    return std::nullopt;
}
#elif defined(__APPLE__)
std::optional<FontFile> fontOfSystem(const std::vector<char32_t>&) { return std::nullopt; }
#else
std::optional<FontFile> fontOfSystem(const std::vector<char32_t>& characters) {
    // Only hexadecimal digits reach the shell.
    std::ostringstream command;
    command << "fc-match -f '%{file}\\n%{index}\\n' 'sans:charset=" << std::hex;
    for (const char32_t c : characters) command << static_cast<std::uint32_t>(c) << ' ';
    command << "' 2>/dev/null";
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.str().c_str(), "r"), pclose);
    if (!pipe) return std::nullopt;
    std::string answer;
    char part[512];
    while (const std::size_t n = std::fread(part, 1, sizeof part, pipe.get())) answer.append(part, n);
    std::istringstream lines(answer);
    FontFile font;
    unsigned index = 0;
    if (!std::getline(lines, font.path) || !(lines >> index)) return std::nullopt;
    font.index = static_cast<int>(index & 0xffff);  // the upper bits select an instance of a variable font
    return font;
}
#endif

}  // namespace

std::optional<FontFile> systemFontWith(const std::vector<char32_t>& characters) {
    static std::mutex mutex;
    static std::map<std::vector<char32_t>, std::optional<FontFile>> known;
    if (characters.empty()) return std::nullopt;
    const std::lock_guard lock(mutex);
    const auto [it, first] = known.try_emplace(characters);
    if (first) it->second = fontOfSystem(characters);
    return it->second;
}

}  // namespace nacre::app
