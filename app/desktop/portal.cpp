#include "app/desktop/portal.h"

#include <dbus/dbus.h>
#include <dlfcn.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <memory>

namespace nacre::app {
namespace {

constexpr const char *kPortal = "org.freedesktop.portal.Desktop", *kObject = "/org/freedesktop/portal/desktop",
                     *kChooser = "org.freedesktop.portal.FileChooser", *kRequest = "org.freedesktop.portal.Request";
constexpr int kCallMilliseconds = 5000;  // milliseconds; the bus may have to start the portal

// clang-format off
#define NACRE_DBUS_CALLS(X) \
    X(threads_init_default) X(error_init) X(error_free) X(bus_get_private) X(bus_register) \
    X(connection_open_private) X(bus_get_unique_name) X(bus_add_match) X(connection_set_exit_on_disconnect) \
    X(connection_close) X(connection_unref) X(connection_read_write) X(connection_pop_message) \
    X(connection_send_with_reply_and_block) X(message_new_method_call) X(message_unref) X(message_is_signal) \
    X(message_get_path) X(message_iter_init) X(message_iter_init_append) X(message_iter_append_basic) \
    X(message_iter_append_fixed_array) X(message_iter_open_container) X(message_iter_close_container) \
    X(message_iter_get_arg_type) X(message_iter_get_basic) X(message_iter_recurse) X(message_iter_next)
// clang-format on

/// libdbus, loaded on demand: linking it with its seven dependencies would add a third to the program's start time.
struct Dbus {
#define NACRE_DECLARE(name) decltype(&dbus_##name) name = nullptr;
    NACRE_DBUS_CALLS(NACRE_DECLARE)
#undef NACRE_DECLARE

    /// Null without the library.
    static const Dbus* get() {
        static const std::unique_ptr<const Dbus> loaded = load();
        return loaded.get();
    }

private:
    static std::unique_ptr<const Dbus> load() {
        void* library = dlopen("libdbus-1.so.3", RTLD_NOW | RTLD_LOCAL);
        if (!library) return nullptr;
        auto dbus = std::make_unique<Dbus>();
        bool whole = true;
        const auto find = [&](auto& function, const char* name) {
            function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(library, name));
            whole &= function != nullptr;
        };
#define NACRE_FIND(name) find(dbus->name, "dbus_" #name);
        NACRE_DBUS_CALLS(NACRE_FIND)
#undef NACRE_FIND
        if (!whole || !dbus->threads_init_default()) return nullptr;
        return dbus;
    }
};

/// A connection of its own to the session's bus.
class Bus {
public:
    explicit Bus(const Dbus& dbus) : dbus_(dbus) {
        DBusError error;
        dbus_.error_init(&error);
        // libdbus caches the address, possibly from before the bus existed.
        const char* address = std::getenv("DBUS_SESSION_BUS_ADDRESS");
        connection_ = address && *address ? dbus_.connection_open_private(address, &error)
                                          : dbus_.bus_get_private(DBUS_BUS_SESSION, &error);
        if (connection_ && address && *address && !dbus_.bus_register(connection_, &error)) {
            dbus_.connection_close(connection_);
            dbus_.connection_unref(connection_);
            connection_ = nullptr;
        }
        dbus_.error_free(&error);
        if (connection_) dbus_.connection_set_exit_on_disconnect(connection_, false);
    }
    ~Bus() {
        if (!connection_) return;
        dbus_.connection_close(connection_);
        dbus_.connection_unref(connection_);
    }
    Bus(const Bus&) = delete;

    using Message = std::unique_ptr<DBusMessage, decltype(&dbus_message_unref)>;
    Message owned(DBusMessage* message) const { return {message, dbus_.message_unref}; }

    bool there() const { return connection_ != nullptr; }
    const Dbus& dbus() const { return dbus_; }
    std::string name() const { return dbus_.bus_get_unique_name(connection_); }

    /// Null on failure.
    Message call(DBusMessage* message) const {
        DBusError error;
        dbus_.error_init(&error);
        const Message sent = owned(message);
        DBusMessage* reply =
            dbus_.connection_send_with_reply_and_block(connection_, sent.get(), kCallMilliseconds, &error);
        dbus_.error_free(&error);
        return owned(reply);
    }
    void listen(const std::string& path) const {
        const std::string rule = std::string("type='signal',interface='") + kRequest + "',path='" + path + "'";
        dbus_.bus_add_match(connection_, rule.c_str(), nullptr);
    }
    /// The next signal on a path; null: the bus is gone.
    Message await(const std::string& path) const {
        do {
            // The signal may have arrived together with the reply.
            while (Message message = owned(dbus_.connection_pop_message(connection_)))
                if (dbus_.message_is_signal(message.get(), kRequest, "Response") &&
                    path == dbus_.message_get_path(message.get()))
                    return message;
        } while (dbus_.connection_read_write(connection_, -1));
        return owned(nullptr);
    }

private:
    const Dbus& dbus_;
    DBusConnection* connection_ = nullptr;
};

/// Writes the arguments of a call.
class Writer {
public:
    Writer(const Dbus& dbus, DBusMessage* message) : dbus_(dbus) { dbus_.message_iter_init_append(message, &at_); }

    void text(const std::string& value) {
        const char* bytes = value.c_str();
        dbus_.message_iter_append_basic(&at_, DBUS_TYPE_STRING, &bytes);
    }
    void beginOptions() { dbus_.message_iter_open_container(&at_, DBUS_TYPE_ARRAY, "{sv}", &options_); }
    void option(const char* name, const std::string& value) {
        inVariant(name, "s", [&](DBusMessageIter& variant) {
            const char* bytes = value.c_str();
            dbus_.message_iter_append_basic(&variant, DBUS_TYPE_STRING, &bytes);
        });
    }
    void yes(const char* name) {
        inVariant(name, "b", [&](DBusMessageIter& variant) {
            const dbus_bool_t value = true;
            dbus_.message_iter_append_basic(&variant, DBUS_TYPE_BOOLEAN, &value);
        });
    }
    /// A path as portals take it: zero-terminated bytes.
    void folder(const char* name, const std::string& value) {
        inVariant(name, "ay", [&](DBusMessageIter& variant) {
            DBusMessageIter array;
            const char* bytes = value.c_str();
            dbus_.message_iter_open_container(&variant, DBUS_TYPE_ARRAY, "y", &array);
            dbus_.message_iter_append_fixed_array(&array, DBUS_TYPE_BYTE, &bytes, static_cast<int>(value.size() + 1));
            dbus_.message_iter_close_container(&variant, &array);
        });
    }
    void endOptions() { dbus_.message_iter_close_container(&at_, &options_); }

private:
    template <typename Write>
    void inVariant(const char* name, const char* type, const Write& write) {
        DBusMessageIter entry, variant;
        dbus_.message_iter_open_container(&options_, DBUS_TYPE_DICT_ENTRY, nullptr, &entry);
        dbus_.message_iter_append_basic(&entry, DBUS_TYPE_STRING, &name);
        dbus_.message_iter_open_container(&entry, DBUS_TYPE_VARIANT, type, &variant);
        write(variant);
        dbus_.message_iter_close_container(&entry, &variant);
        dbus_.message_iter_close_container(&options_, &entry);
    }

    const Dbus& dbus_;
    DBusMessageIter at_{}, options_{};
};

std::string textAt(const Dbus& dbus, DBusMessageIter& at) {
    const int type = dbus.message_iter_get_arg_type(&at);
    if (type != DBUS_TYPE_STRING && type != DBUS_TYPE_OBJECT_PATH) return {};
    const char* text = "";
    dbus.message_iter_get_basic(&at, &text);
    return text;
}

/// "uris" in the results of a successful response.
std::vector<std::string> chosenBy(const Dbus& dbus, DBusMessage* response) {
    std::vector<std::string> paths;
    DBusMessageIter at, results, entry, variant, list;
    if (!dbus.message_iter_init(response, &at) || dbus.message_iter_get_arg_type(&at) != DBUS_TYPE_UINT32) return paths;
    dbus_uint32_t code = 2;
    dbus.message_iter_get_basic(&at, &code);
    if (code != 0 || !dbus.message_iter_next(&at) || dbus.message_iter_get_arg_type(&at) != DBUS_TYPE_ARRAY)
        return paths;
    for (dbus.message_iter_recurse(&at, &results); dbus.message_iter_get_arg_type(&results) == DBUS_TYPE_DICT_ENTRY;
         dbus.message_iter_next(&results)) {
        dbus.message_iter_recurse(&results, &entry);
        if (textAt(dbus, entry) != "uris" || !dbus.message_iter_next(&entry)) continue;
        dbus.message_iter_recurse(&entry, &variant);
        if (dbus.message_iter_get_arg_type(&variant) != DBUS_TYPE_ARRAY) continue;
        for (dbus.message_iter_recurse(&variant, &list); dbus.message_iter_get_arg_type(&list) == DBUS_TYPE_STRING;
             dbus.message_iter_next(&list))
            if (const std::string path = pathOfUri(textAt(dbus, list)); !path.empty()) paths.push_back(path);
    }
    return paths;
}

PortalAnswer choose(const char* method, const std::string& title, const std::string& suggested) {
    const Dbus* dbus = Dbus::get();
    if (!dbus) return {};
    const Bus bus(*dbus);
    if (!bus.there()) return {};
    // The request's object path is chosen before the call, so that an early signal is not missed.
    static std::atomic<int> requests{0};
    const std::string token = "nacre" + std::to_string(getpid()) + "_" + std::to_string(++requests);
    std::string sender = bus.name().substr(1);
    std::replace(sender.begin(), sender.end(), '.', '_');
    std::string path = std::string(kObject) + "/request/" + sender + "/" + token;
    bus.listen(path);
    DBusMessage* message = dbus->message_new_method_call(kPortal, kObject, kChooser, method);
    if (!message) return {};
    Writer call(*dbus, message);
    call.text("");  // no parent window
    call.text(title);
    call.beginOptions();
    call.option("handle_token", token);
    if (suggested.empty()) {
        call.yes("multiple");
    } else {
        const std::filesystem::path whole = std::filesystem::absolute(suggested);
        call.option("current_name", whole.filename().string());
        call.folder("current_folder", whole.parent_path().string());
    }
    call.endOptions();
    const Bus::Message reply = bus.call(message);
    DBusMessageIter at;
    if (!reply || !dbus->message_iter_init(reply.get(), &at)) return {};
    // portals before 0.9 choose a path of their own
    if (const std::string told = textAt(*dbus, at); !told.empty() && told != path) {
        path = told;
        bus.listen(path);
    }
    const Bus::Message response = bus.await(path);
    if (!response) return {true, {}};
    return {true, chosenBy(*dbus, response.get())};
}

}  // namespace

bool hasPortal() {
    const Dbus* dbus = Dbus::get();
    if (!dbus) return false;
    const Bus bus(*dbus);
    if (!bus.there()) return false;
    for (const char* method : {"ListNames", "ListActivatableNames"}) {
        const Bus::Message reply = bus.call(dbus->message_new_method_call(
            "org.freedesktop.DBus", "/org/freedesktop/DBus", "org.freedesktop.DBus", method));
        DBusMessageIter at, names;
        if (!reply || !dbus->message_iter_init(reply.get(), &at) ||
            dbus->message_iter_get_arg_type(&at) != DBUS_TYPE_ARRAY)
            continue;
        for (dbus->message_iter_recurse(&at, &names); dbus->message_iter_get_arg_type(&names) == DBUS_TYPE_STRING;
             dbus->message_iter_next(&names))
            if (textAt(*dbus, names) == kPortal) return true;
    }
    return false;
}

PortalAnswer openByPortal(const std::string& title) { return choose("OpenFile", title, ""); }

PortalAnswer saveByPortal(const std::string& title, const std::string& suggested) {
    return choose("SaveFile", title, suggested);
}

std::string pathOfUri(const std::string& uri) {
    constexpr std::string_view kScheme = "file://";
    if (!uri.starts_with(kScheme)) return {};
    const std::size_t start = uri.find('/', kScheme.size());  // after the host
    if (start == std::string::npos) return {};
    const auto digit = [&](std::size_t i) {
        const char c = i < uri.size() ? uri[i] : ' ';
        return c >= '0' && c <= '9'   ? c - '0'
               : c >= 'a' && c <= 'f' ? c - 'a' + 10
               : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                      : -1;
    };
    std::string path;
    for (std::size_t i = start; i < uri.size(); ++i) {
        if (uri[i] != '%') {
            path += uri[i];
            continue;
        }
        const int value = digit(i + 1) * 16 + digit(i + 2);
        if (digit(i + 1) < 0 || digit(i + 2) < 0 || value == 0) return {};
        path += static_cast<char>(value);
        i += 2;
    }
    return path;
}

}  // namespace nacre::app
