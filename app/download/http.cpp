#include "app/download/http.h"

#include <curl/curl.h>
#include <sys/socket.h>

#include <charconv>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <optional>
#include <system_error>

#include "app/download/allowed_hosts.h"
#ifdef NACRE_CURL_LIBRARY
#include <dlfcn.h>
#endif

namespace nacre::app {
namespace {

/// libcurl, loaded by the first download: it requires about 25 libraries, a third of a short command's time. Its
/// functions, named without prefix: curl_easy_setopt is also a macro.
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

/// @throws HttpFailure if it cannot be loaded or started
const CurlLibrary& curlLibrary() {
    static const CurlLibrary curl = started();
    return curl;
}

struct CloseHandle {
    void operator()(CURL* handle) const { curlLibrary().cleanup(handle); }
};
using Handle = std::unique_ptr<CURL, CloseHandle>;

struct FreeList {
    void operator()(curl_slist* list) const { curlLibrary().freeAll(list); }
};
using Headers = std::unique_ptr<curl_slist, FreeList>;

using OnProgress = std::function<void(std::uint64_t, std::uint64_t)>;

struct Transfer {
    Transfer(CURL* curl, const HttpLimits& most, HttpBody& target, const OnProgress& progress)
        : handle(curl), limits(most), body(target), onProgress(progress) {}

    CURL* handle;
    const HttpLimits& limits;
    HttpBody& body;
    const OnProgress& onProgress;
    std::uint64_t asked = 0;  // first byte of the requested range
    std::uint64_t total = 0;  // bytes of the whole file; 0: not known
    bool began = false;
    std::string refusal;            // reason for our abort
    std::exception_ptr bodyFailed;  // exceptions must not pass through C
};

std::string readHeader(CURL* handle, const char* name) {
    curl_header* header = nullptr;
    if (curlLibrary().header(handle, name, 0, CURLH_HEADER, -1, &header) != CURLHE_OK) return {};
    return header->value;
}

/// The version for a later request (RFC 9110, 13.1.5: no weak ETag).
std::string readValidator(CURL* handle) {
    std::string tag = readHeader(handle, "ETag");
    if (!tag.empty() && tag.rfind("W/", 0) != 0) return tag;
    return readHeader(handle, "Last-Modified");
}

long readStatus(CURL* handle) {
    long status = 0;
    curlLibrary().getInfo(handle, CURLINFO_RESPONSE_CODE, &status);
    return status;
}

/// First byte and total size of "bytes FIRST-LAST/SIZE" (0 if SIZE is '*').
std::optional<std::pair<std::uint64_t, std::uint64_t>> contentRange(const std::string& text) {
    constexpr std::string_view kUnit = "bytes ";
    if (text.rfind(kUnit, 0) != 0) return std::nullopt;
    const char* const end = text.data() + text.size();
    std::uint64_t first = 0, last = 0, size = 0;
    auto parsed = std::from_chars(text.data() + kUnit.size(), end, first);
    if (parsed.ec != std::errc() || parsed.ptr == end || *parsed.ptr != '-') return std::nullopt;
    parsed = std::from_chars(parsed.ptr + 1, end, last);
    if (parsed.ec != std::errc() || parsed.ptr == end || *parsed.ptr != '/') return std::nullopt;
    if (*(parsed.ptr + 1) != '*' && std::from_chars(parsed.ptr + 1, end, size).ec != std::errc()) return std::nullopt;
    return std::pair{first, size};
}

std::string tooLarge(const Transfer& transfer) {
    return "the file is larger than the limit of " + std::to_string(transfer.limits.maxBytes) + " bytes";
}

/// After the headers: decides whether the body continues or restarts. @returns false to abort
bool begin(Transfer& transfer) {
    transfer.began = true;
    const long status = readStatus(transfer.handle);
    if (status != 200 && status != 206) return true;  // the body of an error is ignored
    curl_off_t length = -1;
    curlLibrary().getInfo(transfer.handle, CURLINFO_CONTENT_LENGTH_DOWNLOAD_T, &length);
    if (status == 206) {
        const auto range = contentRange(readHeader(transfer.handle, "Content-Range"));
        if (transfer.asked == 0 || !range || range->first != transfer.asked) {
            transfer.refusal = "the server sent the wrong part of the file";
            return false;
        }
    } else {
        transfer.body.restart(readValidator(transfer.handle));
    }
    if (length >= 0) transfer.total = transfer.body.size() + static_cast<std::uint64_t>(length);
    if (transfer.total <= transfer.limits.maxBytes) return true;
    transfer.refusal = tooLarge(transfer);
    return false;
}

std::size_t receive(char* bytes, std::size_t, std::size_t count, void* pointer) {
    Transfer& transfer = *static_cast<Transfer*>(pointer);
    try {
        if (!transfer.began && !begin(transfer)) return CURL_WRITEFUNC_ERROR;
        const long status = readStatus(transfer.handle);
        if (status != 200 && status != 206) {
            transfer.refusal = "-";  // the status is a sufficient reason
            return CURL_WRITEFUNC_ERROR;
        }
        if (transfer.body.size() + count > transfer.limits.maxBytes) {
            transfer.refusal = tooLarge(transfer);
            return CURL_WRITEFUNC_ERROR;
        }
        transfer.body.append({bytes, count});
        if (transfer.onProgress) transfer.onProgress(transfer.body.size(), transfer.total);
        return count;
    } catch (...) {
        transfer.bodyFailed = std::current_exception();
        return CURL_WRITEFUNC_ERROR;
    }
}

/// Resumes from the body's end if the version is unchanged: otherwise the server sends everything.
Headers rangeHeaders(Transfer& transfer) {
    const std::string validator = transfer.body.validator();
    if (transfer.body.size() == 0 || validator.empty()) return {};
    transfer.asked = transfer.body.size();
    Headers headers(curlLibrary().append(nullptr, ("Range: bytes=" + std::to_string(transfer.asked) + "-").c_str()));
    curlLibrary().append(headers.get(), ("If-Range: " + validator).c_str());
    return headers;
}

/// Checks the resolved address: a public name may resolve to a private one.
curl_socket_t openPublic(void*, curlsocktype, curl_sockaddr* address) {
    return isPublic(address->addr) ? ::socket(address->family, address->socktype, address->protocol) : CURL_SOCKET_BAD;
}

/// The first of some environment variables that has a value.
std::string readEnvironment(std::initializer_list<const char*> names) {
    for (const char* name : names)
        if (const char* value = std::getenv(name); value && *value) return value;
    return {};
}

/// Connects only to public addresses, or to the environment's proxy for this address, which may have a private one.
/// libcurl's own choice between the two is unknown when a connection is opened, so it is made here.
void keepPublic(CURL* handle, const std::string& url) {
    const std::string proxy = url.starts_with("https:")
                                  ? readEnvironment({"https_proxy", "HTTPS_PROXY", "all_proxy", "ALL_PROXY"})
                                  : readEnvironment({"http_proxy", "all_proxy", "ALL_PROXY"});
    const bool direct = proxy.empty() || isWithoutProxy(parseHost(url), readEnvironment({"no_proxy", "NO_PROXY"}));
    const auto set = curlLibrary().setOption;
    set(handle, CURLOPT_PROXY, direct ? "" : proxy.c_str());  // empty: none, whatever the environment says
    set(handle, CURLOPT_NOPROXY, "");                         // no exceptions
    if (direct) set(handle, CURLOPT_OPENSOCKETFUNCTION, &openPublic);
}

/// A wheel contains Debian's libcurl, which looks for certificates in Debian's location. @returns their file on other
/// systems; empty: Debian's, or unknown
std::string certificatesElsewhere() {
    constexpr const char* kOfDebian = "/etc/ssl/certs/ca-certificates.crt";
    std::error_code error;
    for (const char* path :
         {kOfDebian, "/etc/pki/tls/certs/ca-bundle.crt", "/etc/ssl/ca-bundle.pem", "/etc/ssl/cert.pem"})
        if (std::filesystem::exists(path, error)) return path == std::string_view(kOfDebian) ? "" : path;
    return "";
}

void setOptions(CURL* handle, const std::string& url, const HttpLimits& limits, Transfer& transfer, char* message) {
    const auto set = curlLibrary().setOption;
    const char* scheme = url.rfind("https:", 0) == 0 ? "https" : "http";
    const long seconds = static_cast<long>(limits.patience.count());
    set(handle, CURLOPT_URL, url.c_str());
    set(handle, CURLOPT_PROTOCOLS_STR, scheme);
    set(handle, CURLOPT_REDIR_PROTOCOLS_STR, scheme);
    set(handle, CURLOPT_FOLLOWLOCATION, limits.redirects > 0 ? 1L : 0L);
    set(handle, CURLOPT_MAXREDIRS, limits.redirects);
    set(handle, CURLOPT_CONNECTTIMEOUT, seconds);
    set(handle, CURLOPT_LOW_SPEED_TIME, seconds);
    set(handle, CURLOPT_LOW_SPEED_LIMIT, limits.slowestBytesPerSecond);
    set(handle, CURLOPT_NOSIGNAL, 1L);
    set(handle, CURLOPT_USERAGENT, "nacre/" NACRE_VERSION);
    set(handle, CURLOPT_ERRORBUFFER, message);
    set(handle, CURLOPT_WRITEFUNCTION, &receive);
    set(handle, CURLOPT_WRITEDATA, &transfer);
    if (limits.publicAlone) keepPublic(handle, url);
    const std::string certificates = limits.certificates.empty() ? certificatesElsewhere() : limits.certificates;
    if (!certificates.empty()) set(handle, CURLOPT_CAINFO, certificates.c_str());  // libcurl copies it
}

[[noreturn]] void failOfCurl(CURLcode code, const char* message, const Transfer& transfer) {
    const HttpLimits& limits = transfer.limits;
    switch (code) {
        case CURLE_FILESIZE_EXCEEDED:
            throw HttpFailure(tooLarge(transfer), false);
        case CURLE_OPERATION_TIMEDOUT:
            throw HttpFailure(
                "no answer, or hardly any data, for " + std::to_string(limits.patience.count()) + " seconds", false);
        case CURLE_TOO_MANY_REDIRECTS:
            throw HttpFailure("more than " + std::to_string(limits.redirects) + " redirections", false);
        case CURLE_UNSUPPORTED_PROTOCOL:
            // libcurl reports a missing status line in the same way.
            if (std::string_view(message).find("HTTP/0.9") != std::string_view::npos)
                throw HttpFailure("invalid answer: it has no HTTP status and no headers", false);
            throw HttpFailure("the server redirects to another protocol, which is refused", false);
        case CURLE_PARTIAL_FILE:
        case CURLE_RECV_ERROR:
        case CURLE_HTTP2:
        case CURLE_HTTP2_STREAM:
            throw HttpFailure("the connection was lost before the end of the file", true);
        case CURLE_COULDNT_RESOLVE_HOST:
        case CURLE_COULDNT_RESOLVE_PROXY:
            throw HttpFailure("server not found: check your connection", false);
        case CURLE_COULDNT_CONNECT:
            throw HttpFailure("server not reachable: check your connection", false);
        default:
            throw HttpFailure(*message ? message : curlLibrary().errorText(code), false);
    }
}

[[noreturn]] void failOfStatus(long status) {
    std::string why = "the server answered with status " + std::to_string(status);
    if (status == 404 || status == 410) why = "there is no such entry";
    if (status == 429 || status == 503) why += " (it is busy: try again later)";
    throw HttpFailure(why, false);
}

}  // namespace

void httpGet(const std::string& url, const HttpLimits& limits, HttpBody& body,
             const std::function<void(std::uint64_t, std::uint64_t)>& onProgress) {
    const Handle handle(curlLibrary().init());
    if (!handle) throw HttpFailure("libcurl could not be started", false);
    Transfer transfer(handle.get(), limits, body, onProgress);
    char message[CURL_ERROR_SIZE] = "";
    setOptions(handle.get(), url, limits, transfer, message);
    const Headers headers = rangeHeaders(transfer);
    // Limit for announced sizes; unannounced data is counted as it arrives.
    curlLibrary().setOption(handle.get(), CURLOPT_MAXFILESIZE_LARGE, static_cast<curl_off_t>(limits.maxBytes));
    if (headers) curlLibrary().setOption(handle.get(), CURLOPT_HTTPHEADER, headers.get());

    const CURLcode code = curlLibrary().perform(handle.get());
    if (transfer.bodyFailed) std::rethrow_exception(transfer.bodyFailed);
    const long status = readStatus(handle.get());
    if (status == 416 && transfer.asked > 0) {  // no bytes follow: the existing ones belong to another file
        body.restart("");
        throw HttpFailure("the file has changed on the server", true);
    }
    if (!transfer.refusal.empty() && transfer.refusal != "-") throw HttpFailure(transfer.refusal, false);
    if (code != CURLE_OK && transfer.refusal.empty()) failOfCurl(code, message, transfer);
    if (status != 200 && status != 206) failOfStatus(status);
    if (!transfer.began && !begin(transfer)) throw HttpFailure(transfer.refusal, false);  // an empty file
    if (transfer.total > 0 && body.size() != transfer.total)
        throw HttpFailure("the connection was lost before the end of the file", true);
}

}  // namespace nacre::app
