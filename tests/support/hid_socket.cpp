#include "tests/support/hid_socket.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <linux/hidraw.h>
#include <poll.h>
#include <stdexcept>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace fulcrum::test_support {
namespace {

constexpr int kLook_ms = 5;
constexpr std::size_t kMostBytes = 16384;

int listen_at(const std::string& path) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (path.size() >= sizeof address.sun_path) {
        throw std::runtime_error("too long for a socket: " + path);
    }
    std::memcpy(address.sun_path, path.data(), path.size());
    unlink(path.c_str());
    const int file = socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (file < 0 || bind(file, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0 ||
        listen(file, 8) != 0) {
        throw std::runtime_error("no socket at " + path);
    }
    return file;
}

// Copies text as the kernel does, with its end.
Bytes text_of(const std::string& text) {
    return {text.c_str(), text.c_str() + text.size() + 1};
}

template <class T>
Bytes bytes_of(const T& value) {
    Bytes bytes(sizeof value);
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
}

}  // namespace

HidSocket::HidSocket(hid::HidNode node, std::shared_ptr<VirtualHid> device)
    : node_(std::move(node)),
      device_(std::move(device)),
      reports_(listen_at(node_.path)),
      questions_(listen_at(node_.path + ".ctl")),
      thread_([this] { serve(); }) {}

HidSocket::~HidSocket() {
    ends_.store(true);
    thread_.join();
    unlink(node_.path.c_str());
    unlink((node_.path + ".ctl").c_str());
    close(reports_);
    close(questions_);
    for (const int file : links_) {
        close(file);
    }
}

void HidSocket::report(const Bytes& report) {
    const std::lock_guard lock(mutex_);
    for (const int file : links_) {
        (void)send(file, report.data(), report.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    }
}

std::size_t HidSocket::links() const {
    const std::lock_guard lock(mutex_);
    return links_.size();
}

void HidSocket::serve() {
    while (!ends_.load()) {
        std::vector<pollfd> waits{{reports_, POLLIN, 0}, {questions_, POLLIN, 0}};
        const short orders = stalls_.load() ? 0 : POLLIN;
        for (const int file : links_) {
            waits.push_back({file, orders, 0});
        }
        if (poll(waits.data(), waits.size(), kLook_ms) <= 0) {
            continue;
        }
        std::vector<int> left;
        for (std::size_t i = 2; i < waits.size(); ++i) {
            const bool has_gone = (waits[i].revents & POLLHUP) != 0;
            const bool has_order = (waits[i].revents & POLLIN) != 0;
            if ((has_order && !take_order(waits[i].fd)) || (has_gone && !has_order)) {
                left.push_back(waits[i].fd);
            }
        }
        const std::lock_guard lock(mutex_);
        for (const int file : left) {
            links_.erase(std::find(links_.begin(), links_.end(), file));
            close(file);
        }
        if ((waits[0].revents & POLLIN) != 0) {
            if (const int file = accept4(reports_, nullptr, nullptr, SOCK_CLOEXEC); file >= 0) {
                // Little room, so that a device that stalls is noticed soon.
                const int room = 1;
                (void)setsockopt(file, SOL_SOCKET, SO_RCVBUF, &room, sizeof room);
                links_.push_back(file);
            }
        }
        if ((waits[1].revents & POLLIN) != 0 && !stalls_.load()) {
            answer();
        }
    }
}

// False when nobody is at the other end any more.
bool HidSocket::take_order(int file) {
    std::array<std::uint8_t, kMostBytes> packet{};
    const ssize_t n = recv(file, packet.data(), packet.size(), MSG_DONTWAIT);
    if (n <= 0) {
        return n < 0 && errno == EAGAIN;
    }
    (void)device_->take_output({packet.begin(), packet.begin() + n});
    return true;
}

// One question, as hid_shim puts it: the number of the call and what it pointed to.
void HidSocket::answer() {
    const int file = accept4(questions_, nullptr, nullptr, SOCK_CLOEXEC);
    if (file < 0) {
        return;
    }
    std::array<std::uint8_t, kMostBytes> packet{};
    const ssize_t n = recv(file, packet.data(), packet.size(), 0);
    std::uint32_t number = 0;
    if (n < static_cast<ssize_t>(sizeof number)) {
        close(file);
        return;
    }
    std::memcpy(&number, packet.data(), sizeof number);
    const Bytes given(packet.begin() + sizeof number, packet.begin() + n);
    std::int32_t result = 0;
    Bytes data;
    switch (number) {
        case _IOC_NR(HIDIOCGRDESCSIZE):
            data = bytes_of(static_cast<int>(node_.descriptor.size()));
            break;
        case _IOC_NR(HIDIOCGRDESC): {
            hidraw_report_descriptor whole{};
            whole.size = static_cast<std::uint32_t>(node_.descriptor.size());
            std::copy(node_.descriptor.begin(), node_.descriptor.end(), whole.value);
            data = bytes_of(whole);
            break;
        }
        case _IOC_NR(HIDIOCGRAWINFO):
            data = bytes_of(hidraw_devinfo{3, static_cast<std::int16_t>(node_.vendor),
                                           static_cast<std::int16_t>(node_.product)});
            break;
        case _IOC_NR(HIDIOCGRAWNAME(0)):
            data = text_of(node_.name);
            result = static_cast<std::int32_t>(data.size());
            break;
        case _IOC_NR(HIDIOCGRAWUNIQ(0)):
            data = text_of(node_.serial);
            result = static_cast<std::int32_t>(data.size());
            break;
        case _IOC_NR(HIDIOCSFEATURE(0)):
            result =
                device_->take_feature(given) ? static_cast<std::int32_t>(given.size()) : -EPIPE;
            break;
        case _IOC_NR(HIDIOCGFEATURE(0)): {
            data = device_->give_feature(given.empty() ? std::uint8_t{0} : given[0]);
            result = data.empty() ? -EPIPE : static_cast<std::int32_t>(data.size());
            break;
        }
        default:
            result = -EINVAL;
    }
    data.resize(std::min(data.size(), given.size()));
    Bytes reply = bytes_of(result);
    reply.insert(reply.end(), data.begin(), data.end());
    (void)send(file, reply.data(), reply.size(), MSG_NOSIGNAL);
    close(file);
}

}  // namespace fulcrum::test_support
