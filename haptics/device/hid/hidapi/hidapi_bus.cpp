#include "haptics/device/hid/hidapi/hidapi_bus.h"

#include <hidapi.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <linux/hidraw.h>
#include <mutex>
#include <sys/ioctl.h>
#include <unistd.h>

namespace fulcrum::hid {
namespace {

constexpr std::size_t kMostNodes = 256;
constexpr std::size_t kMostName = 256;

// hidapi's own state: its error text, its beginning.
std::mutex& hidapi_mutex() {
    static std::mutex mutex;
    return mutex;
}

// Control characters and what is no ASCII are left out: a name goes to terminals and into sentences.
template <class Char>
std::string plain(const Char* text) {
    std::string made;
    for (; text != nullptr && *text != 0 && made.size() < kMostName; ++text) {
        if (*text >= Char{0x20} && *text < Char{0x7F}) {
            made.push_back(static_cast<char>(*text));
        }
    }
    return made;
}

// As the kernel keeps it; readable without opening the device.
std::vector<std::uint8_t> read_descriptor_of(const std::string& path) {
    const auto base = std::filesystem::path(path).filename().string();
    std::ifstream file("/sys/class/hidraw/" + base + "/device/report_descriptor", std::ios::binary);
    std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(file), {}};
    return bytes.size() <= HID_MAX_DESCRIPTOR_SIZE ? bytes : std::vector<std::uint8_t>{};
}

HidNode make_node(const hid_device_info& info) {
    HidNode node;
    node.path = info.path;
    node.name = plain(info.product_string);
    node.serial = plain(info.serial_number);
    node.vendor = info.vendor_id;
    node.product = info.product_id;
    node.descriptor = read_descriptor_of(node.path);
    node.may_open = access(node.path.c_str(), R_OK | W_OK) == 0;
    return node;
}

// A descriptor of a file that closes itself.
class File {
  public:
    explicit File(const std::string& path) : number_(::open(path.c_str(), O_RDWR | O_CLOEXEC)) {}
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    ~File() {
        if (number_ >= 0) {
            ::close(number_);
        }
    }
    [[nodiscard]] int number() const noexcept { return number_; }

  private:
    int number_;
};

// What the kernel says of an opened device; false when it is none of HID.
bool ask_kernel(int file, HidNode& node) {
    int size = 0;
    if (ioctl(file, HIDIOCGRDESCSIZE, &size) < 0 || size < 0 || size > HID_MAX_DESCRIPTOR_SIZE) {
        return false;
    }
    hidraw_report_descriptor descriptor{};
    descriptor.size = static_cast<std::uint32_t>(size);
    hidraw_devinfo info{};
    if (ioctl(file, HIDIOCGRDESC, &descriptor) < 0 || ioctl(file, HIDIOCGRAWINFO, &info) < 0) {
        return false;
    }
    node.descriptor.assign(descriptor.value, descriptor.value + size);
    node.vendor = static_cast<std::uint16_t>(info.vendor);
    node.product = static_cast<std::uint16_t>(info.product);
    char name[kMostName] = {};
    if (ioctl(file, HIDIOCGRAWNAME(kMostName - 1), name) >= 0) {
        node.name = plain(name);
    }
    char serial[kMostName] = {};
    if (ioctl(file, HIDIOCGRAWUNIQ(kMostName - 1), serial) >= 0) {
        node.serial = plain(serial);
    }
    return true;
}

class HidapiLink final : public HidLink {
  public:
    explicit HidapiLink(hid_device* device) : device_(device) {}
    ~HidapiLink() override {
        const std::lock_guard lock(hidapi_mutex());
        hid_close(device_);
    }

    int read(std::span<std::uint8_t> report, int timeout_ms) override {
        return hid_read_timeout(device_, report.data(), report.size(), timeout_ms);
    }
    bool write(std::span<const std::uint8_t> report) override {
        return hid_write(device_, report.data(), report.size()) >= 0;
    }
    bool send_feature(std::span<const std::uint8_t> report) override {
        return hid_send_feature_report(device_, report.data(), report.size()) >= 0;
    }
    int get_feature(std::span<std::uint8_t> report) override {
        return hid_get_feature_report(device_, report.data(), report.size());
    }

  private:
    hid_device* device_;
};

class HidapiBus final : public HidBus {
  public:
    std::vector<HidNode> list() override {
        const std::lock_guard lock(hidapi_mutex());
        std::vector<HidNode> nodes;
        hid_device_info* const first = hid_enumerate(0, 0);
        for (const auto* info = first; info != nullptr && nodes.size() < kMostNodes;
             info = info->next) {
            // One for each top collection; they stand behind each other.
            if (info->path != nullptr && (nodes.empty() || nodes.back().path != info->path)) {
                nodes.push_back(make_node(*info));
            }
        }
        hid_free_enumeration(first);
        return nodes;
    }

    Expected<HidNode> look(const std::string& path) override {
        HidNode node;
        node.path = path;
        const File file(path);
        if (file.number() < 0) {
            return explain_closed(path, errno);
        }
        if (!ask_kernel(file.number(), node)) {
            return fail("this is no HID device", path, "fulcrum devices lists what is there");
        }
        node.may_open = true;
        return node;
    }

    Expected<std::unique_ptr<HidLink>> open(const std::string& path) override {
        // hidapi 0.13 leaks a device that opens and then is no HID device.
        if (const auto node = look(path); !node) {
            return tl::unexpected(node.error());
        }
        const std::lock_guard lock(hidapi_mutex());
        hid_device* const device = hid_open_path(path.c_str());
        if (device == nullptr) {
            return fail("the device cannot be opened: " + plain(hid_error(nullptr)), path,
                        "fulcrum devices says what is missing");
        }
        return std::make_unique<HidapiLink>(device);
    }

  private:
    // What may not be opened can still be told of.
    Expected<HidNode> explain_closed(const std::string& path, int error) {
        if (error == EACCES || error == EPERM) {
            std::vector<HidNode> nodes = list();
            const auto found = std::find_if(nodes.begin(), nodes.end(),
                                            [&](const HidNode& n) { return n.path == path; });
            if (found != nodes.end()) {
                found->may_open = false;
                return std::move(*found);
            }
        }
        return fail(std::string("there is no device to be opened: ") + std::strerror(error), path,
                    "fulcrum devices lists what is there");
    }
};

}  // namespace

std::shared_ptr<HidBus> make_hidapi_bus() {
    return std::make_shared<HidapiBus>();
}

}  // namespace fulcrum::hid
