// The way to HID devices: which there are, and one that was opened. Behind it stands hidapi (hidapi/hidapi_bus.h), nothing where that
// is left out (no_hidapi/), or in tests a device of memory.
//
// Thread: a bus by any thread at any time; a link by one thread at a time. `list`, `look` and `open` take milliseconds.
#pragma once

#include "haptics/base/error.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fulcrum::hid {

/// A device as it is found, before anybody opens it.
struct HidNode {
    std::string path;    ///< e.g. /dev/hidraw3
    std::string name;    ///< for people; may be empty
    std::string serial;  ///< may be empty
    std::uint16_t vendor = 0;
    std::uint16_t product = 0;
    std::vector<std::uint8_t> descriptor;  ///< report descriptor; empty where it cannot be read
    bool may_open = false;                 ///< this user may read and write it
};

/// An opened device. Destroying it closes it.
class HidLink {
  public:
    HidLink() = default;
    HidLink(const HidLink&) = delete;
    HidLink& operator=(const HidLink&) = delete;
    virtual ~HidLink() = default;

    /// The next input report, its number first where reports are numbered: its bytes, 0 when none came within
    /// `timeout_ms`, -1 when the device has gone.
    [[nodiscard]] virtual int read(std::span<std::uint8_t> report, int timeout_ms) = 0;
    /// Sends an output report, its number (or 0) first. False when the device did not take it. May wait as long as the
    /// device does: for threads that may be held up.
    [[nodiscard]] virtual bool write(std::span<const std::uint8_t> report) = 0;
    /// Sends a feature report, likewise.
    [[nodiscard]] virtual bool send_feature(std::span<const std::uint8_t> report) = 0;
    /// Asks for the feature report whose number is report[0]: its bytes with that number, -1 when there was no answer.
    [[nodiscard]] virtual int get_feature(std::span<std::uint8_t> report) = 0;
};

class HidBus {
  public:
    HidBus() = default;
    HidBus(const HidBus&) = delete;
    HidBus& operator=(const HidBus&) = delete;
    virtual ~HidBus() = default;

    /// Why there is never any, where this build leaves them out.
    [[nodiscard]] virtual std::optional<Error> why_never() const { return std::nullopt; }
    /// All HID devices that the system knows, also those that may not be opened.
    [[nodiscard]] virtual std::vector<HidNode> list() = 0;
    /// What stands at this path now. Says why there is nothing, or nothing that may be opened.
    [[nodiscard]] virtual Expected<HidNode> look(const std::string& path) = 0;
    /// Opens the device for reading and writing; more than one link to a device may be open.
    [[nodiscard]] virtual Expected<std::unique_ptr<HidLink>> open(const std::string& path) = 0;
};

}  // namespace fulcrum::hid
