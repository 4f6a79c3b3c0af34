#include "app/download/curl_library.h"

#include "app/download/http.h"
#ifdef NACRE_CURL_LIBRARY
#include <dlfcn.h>
#endif

namespace nacre::app {
namespace {

#ifdef NACRE_CURL_LIBRARY

template <typename Call>
void find(void* library, const char* name, Call& call) {
    call = reinterpret_cast<Call>(dlsym(library, name));
    if (!call) throw HttpFailure(std::string(NACRE_CURL_LIBRARY) + " lacks " + name, false);
}

CurlLibrary loaded() {
    void* const library = dlopen(NACRE_CURL_LIBRARY, RTLD_LAZY | RTLD_LOCAL);  // never unloaded: it has threads
    if (!library) throw HttpFailure(std::string("libcurl cannot be loaded: ") + dlerror(), false);
    CurlLibrary curl{};
    find(library, "curl_global_init", curl.globalInit);
    find(library, "curl_easy_init", curl.init);
    find(library, "curl_easy_cleanup", curl.cleanup);
    find(library, "curl_easy_setopt", curl.setOption);
    find(library, "curl_easy_getinfo", curl.getInfo);
    find(library, "curl_easy_perform", curl.perform);
    find(library, "curl_easy_header", curl.header);
    find(library, "curl_easy_strerror", curl.errorText);
    find(library, "curl_slist_append", curl.append);
    find(library, "curl_slist_free_all", curl.freeAll);
    return curl;
}

#else

CurlLibrary loaded() {
    return {curl_global_init,  curl_easy_init,   curl_easy_cleanup,  ::curl_easy_setopt, ::curl_easy_getinfo,
            curl_easy_perform, curl_easy_header, curl_easy_strerror, curl_slist_append,  curl_slist_free_all};
}

#endif

CurlLibrary started() {
    const CurlLibrary curl = loaded();
    const CURLcode code = curl.globalInit(CURL_GLOBAL_DEFAULT);
    if (code != CURLE_OK) throw HttpFailure(curl.errorText(code), false);
    return curl;
}

}  // namespace

const CurlLibrary& curlLibrary() {
    static const CurlLibrary curl = started();
    return curl;
}

}  // namespace nacre::app
