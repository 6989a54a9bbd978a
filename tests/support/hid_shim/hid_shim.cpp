// Makes a socket look like a HID device of Linux, so that hidapi's own code runs where there is no device: preloaded, or linked
// before the C library.
//
//   open("X.hid")         connects to the socket X.hid, where hid_socket.h serves a device: reports as packets, either way
//   open("/dev/hidrawN")  the same with $FULCRUM_HID_NODES/hidrawN.hid, where that is set
//   ioctl('H', …)         on such a file is asked of the socket X.hid.ctl, one question a connection
// What stands in $FULCRUM_HID_FORBIDDEN may not be opened. Unplugging is the socket's end: poll says so, as for hidraw.
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <linux/hidraw.h>
#include <string>
#include <string_view>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>
#include <vector>

namespace {

constexpr std::string_view kEnding = ".hid";
constexpr std::string_view kNode = "/dev/hidraw";

template <class Function>
Function* next(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

// Where the device of this path listens; empty when it is none of ours.
std::string socket_of(const char* path) {
    const std::string_view name(path == nullptr ? "" : path);
    if (name.ends_with(kEnding)) {
        return std::string(name);
    }
    const char* const folder = std::getenv("FULCRUM_HID_NODES");
    if (folder == nullptr || !name.starts_with(kNode)) {
        return {};
    }
    const std::string served =
        std::string(folder) + "/" + std::string(name.substr(std::strlen("/dev/"))) + ".hid";
    return access(served.c_str(), F_OK) == 0 ? served : std::string();
}

int connect_to(const std::string& path) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (path.size() >= sizeof address.sun_path) {
        errno = ENAMETOOLONG;
        return -1;
    }
    std::memcpy(address.sun_path, path.data(), path.size());
    const int file = socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0);
    if (file >= 0 && connect(file, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) {
        const int why = errno;
        close(file);
        errno = why == ECONNREFUSED ? ENODEV : why;
        return -1;
    }
    return file;
}

// The path that a socket of ours was connected to; empty for anything else.
std::string peer_of(int file) {
    sockaddr_un address{};
    socklen_t size = sizeof address;
    if (getpeername(file, reinterpret_cast<sockaddr*>(&address), &size) != 0 ||
        address.sun_family != AF_UNIX) {
        return {};
    }
    const std::string path(address.sun_path);
    return path.ends_with(kEnding) ? path : std::string();
}

int open_here(const char* name, const char* path, int flags, mode_t mode) {
    const std::string served = socket_of(path);
    if (served.empty()) {
        return next<int(const char*, int, ...)>(name)(path, flags, mode);
    }
    const char* const forbidden = std::getenv("FULCRUM_HID_FORBIDDEN");
    if (forbidden != nullptr && served.find(forbidden) != std::string::npos) {
        errno = EACCES;
        return -1;
    }
    return connect_to(served);
}

// Asks the device; its answer replaces what `data` points to.
int ask(const std::string& path, unsigned long request, void* data) {
    const int file = connect_to(path + ".ctl");
    if (file < 0) {
        return -1;
    }
    const std::uint32_t number = _IOC_NR(request);
    // The kernel looks at what a descriptor says of its size, not at the size of the call.
    const std::size_t size = _IOC_SIZE(request);
    std::vector<std::uint8_t> packet(sizeof number + size);
    std::memcpy(packet.data(), &number, sizeof number);
    std::memcpy(packet.data() + sizeof number, data, size);
    std::int32_t result = -EIO;
    if (send(file, packet.data(), packet.size(), MSG_NOSIGNAL) ==
        static_cast<ssize_t>(packet.size())) {
        std::vector<std::uint8_t> answer(sizeof result + size);
        const ssize_t n = recv(file, answer.data(), answer.size(), 0);
        if (n >= static_cast<ssize_t>(sizeof result)) {
            std::memcpy(&result, answer.data(), sizeof result);
            std::memcpy(data, answer.data() + sizeof result,
                        static_cast<std::size_t>(n) - sizeof result);
        }
    }
    close(file);
    if (result < 0) {
        errno = -result;
        return -1;
    }
    return result;
}

// Writing to a device that has gone is an error, and no signal.
__attribute__((constructor)) void mind_no_pipe() {
    std::signal(SIGPIPE, SIG_IGN);
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = static_cast<mode_t>(va_arg(arguments, int));
    va_end(arguments);
    return open_here("open", path, flags, mode);
}

int open64(const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = static_cast<mode_t>(va_arg(arguments, int));
    va_end(arguments);
    return open_here("open64", path, flags, mode);
}

int ioctl(int file, unsigned long request, ...) noexcept {
    va_list arguments;
    va_start(arguments, request);
    void* const data = va_arg(arguments, void*);
    va_end(arguments);
    if (_IOC_TYPE(request) == 'H') {
        if (const std::string path = peer_of(file); !path.empty()) {
            return ask(path, request, data);
        }
    }
    return next<int(int, unsigned long, ...)>("ioctl")(file, request, data);
}
}
