// What stands for hidapi/ in a build without FULCRUM_HID.
#include "haptics/device/hid/hidapi/hidapi_bus.h"

namespace fulcrum::hid {
namespace {

class NoBus final : public HidBus {
  public:
    [[nodiscard]] std::optional<Error> why_never() const override {
        return Error{"this build has no HID devices",
                     {},
                     "build with -DFULCRUM_HID=ON, or choose another hand"};
    }
    std::vector<HidNode> list() override { return {}; }
    Expected<HidNode> look(const std::string& /*path*/) override {
        return tl::unexpected(*why_never());
    }
    Expected<std::unique_ptr<HidLink>> open(const std::string& /*path*/) override {
        return tl::unexpected(*why_never());
    }
};

}  // namespace

std::shared_ptr<HidBus> make_hidapi_bus() {
    return std::make_shared<NoBus>();
}

}  // namespace fulcrum::hid
