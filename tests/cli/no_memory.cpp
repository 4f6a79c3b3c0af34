// Preloaded: operator new refuses more than NACRE_TEST_MOST_BYTES at once; with NACRE_TEST_NONE_AFTER it then refuses
// everything, so that nothing may allocate after an error.

#include <atomic>
#include <cstdlib>
#include <new>

void* operator new(std::size_t size) {
    static const char* const most = std::getenv("NACRE_TEST_MOST_BYTES");
    static const std::size_t limit = most ? std::strtoull(most, nullptr, 10) : ~std::size_t{0};
    static const bool noneAfter = std::getenv("NACRE_TEST_NONE_AFTER") != nullptr;
    static std::atomic<bool> refused{false};
    if (size > limit && noneAfter) refused = true;
    void* const memory = size > limit || refused ? nullptr : std::malloc(size > 0 ? size : 1);
    if (!memory) throw std::bad_alloc();
    return memory;
}
