#pragma once
// libcurl, loaded by the first download: it requires about 25 libraries, a third of a short command's time.

#include <curl/curl.h>

namespace nacre::app {

/// Its functions, named without prefix: curl_easy_setopt is also a macro.
struct CurlLibrary {
    decltype(&curl_global_init) globalInit;
    decltype(&curl_easy_init) init;
    decltype(&curl_easy_cleanup) cleanup;
    decltype(&::curl_easy_setopt) setOption;
    decltype(&::curl_easy_getinfo) getInfo;
    decltype(&curl_easy_perform) perform;
    decltype(&curl_easy_header) header;
    decltype(&curl_easy_strerror) errorText;
    decltype(&curl_slist_append) append;
    decltype(&curl_slist_free_all) freeAll;
};

/// @throws HttpFailure if it cannot be loaded or started
const CurlLibrary& curlLibrary();

}  // namespace nacre::app
