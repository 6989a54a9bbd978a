// Serves a virtual HID device at a socket that hid_shim makes look like one of Linux.
#pragma once

#include "haptics/device/hid/hid_link.h"
#include "tests/support/virtual_hid.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace fulcrum::test_support {

class HidSocket {
  public:
    /// Plugs it in at `node.path`, which ends in ".hid". Throws when it cannot.
    HidSocket(hid::HidNode node, std::shared_ptr<VirtualHid> device);
    HidSocket(const HidSocket&) = delete;
    HidSocket& operator=(const HidSocket&) = delete;
    /// Unplugs it.
    ~HidSocket();

    /// An input report to everybody who has it open; who does not read loses it, as with hidraw.
    void report(const Bytes& report);
    /// While true, orders are not taken.
    void stall(bool stalls) { stalls_.store(stalls); }
    /// How many have it open.
    [[nodiscard]] std::size_t links() const;

  private:
    void serve();
    void answer();
    [[nodiscard]] bool take_order(int file);

    hid::HidNode node_;
    std::shared_ptr<VirtualHid> device_;
    int reports_ = -1;    // listens
    int questions_ = -1;  // likewise
    mutable std::mutex mutex_;
    std::vector<int> links_;
    std::atomic<bool> stalls_{false};
    std::atomic<bool> ends_{false};
    std::thread thread_;
};

}  // namespace fulcrum::test_support
