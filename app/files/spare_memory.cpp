#include "app/files/spare_memory.h"

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

#include <atomic>

namespace nacre::app {

void givePicturesMemoryBack() {
#ifdef M_TRIM_THRESHOLD
    constexpr unsigned kPictures = 64;  // between two calls: it takes some milliseconds
    static std::atomic<unsigned> pictures{0};
    if (++pictures % kPictures == 0) malloc_trim(0);
#endif
}

}  // namespace nacre::app
