#pragma once
// Message and position of a PEGTL parse error, in both forms: Debian's gemmi is built with PEGTL 3, upstream's includes
// PEGTL 2.8, whose errors have a public list of positions and begin with them.

#include <cstddef>
#include <string>

namespace nacre {

template <typename Fault>
auto faultMessage(const Fault& fault, int) -> decltype(std::string(fault.message())) {
    return std::string(fault.message());
}
/// PEGTL 2.8: "SOURCE:LINE:COLUMN(BYTE): words".
template <typename Fault>
std::string faultMessage(const Fault& fault, long) {
    const std::string text = fault.what();
    const std::size_t end = text.find("): ");
    return end == std::string::npos ? text : text.substr(end + 3);
}
/// The message without a position.
template <typename Fault>
std::string faultMessage(const Fault& fault) {
    return faultMessage(fault, 0);
}

template <typename Fault>
auto lineNumber(const Fault& fault, int) -> decltype(static_cast<std::size_t>(fault.positions().front().line)) {
    return fault.positions().front().line;
}
template <typename Fault>
std::size_t lineNumber(const Fault& fault, long) {
    return fault.positions.front().line;
}
/// The position.
template <typename Fault>
std::size_t lineNumber(const Fault& fault) {
    return lineNumber(fault, 0);
}

}  // namespace nacre
