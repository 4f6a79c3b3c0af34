#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

namespace nacre {

/// The one exception for faults of environment or input (device, memory, file). Caught in app/ only.
/// what() reads `WHAT: WHERE (line N): WHY` without empty parts.
class Error : public std::runtime_error {
public:
    /// @param what  the failed action ("cannot read molecule")
    /// @param where file, object or option; may be empty
    /// @param why   the reason, and a remedy if there is one
    /// @param line  1-based line of a text file, if there is one
    Error(const std::string& what, const std::string& where, const std::string& why,
          std::optional<std::uint64_t> line = std::nullopt)
        : std::runtime_error(join(what, where, why, line)) {}

private:
    static std::string join(const std::string& what, const std::string& where, const std::string& why,
                            std::optional<std::uint64_t> line) {
        std::string text = what;
        if (!where.empty()) text += ": " + where;
        if (line) text += " (line " + std::to_string(*line) + ")";
        if (!why.empty()) text += ": " + why;
        return text;
    }
};

}  // namespace nacre
