// The way to an arm on a link: its socket, its key's seal, and where it is an arm at this computer the process that serves it.
//
// Thread: load path. Cost: a greeting takes as long as the way there and back; kGreeting_s where nobody answers.
#pragma once

#include "haptics/base/error.h"
#include "haptics/link/link_device.h"
#include "runtime/app/own_arm.h"
#include "runtime/app/run_request.h"
#include "runtime/link/sodium_seal.h"
#include "runtime/link/udp_socket.h"

#include <memory>
#include <string>

namespace fulcrum::runtime {

inline constexpr double kGreeting_s = 3.0;

class ArmLine {
  public:
    /// To the arm of a choice of HandKind::link; an arm at this computer is there already (`meet_arms`), or is started.
    [[nodiscard]] static Expected<std::unique_ptr<ArmLine>> open(const HandChoice& choice);

    /// A device at the other end, which has said what it is. The line must outlive it. `began_s`: the zero of its clock, monotonic.
    [[nodiscard]] Expected<std::unique_ptr<LinkDevice>> greet(const LinkDeviceSettings& settings,
                                                              double began_s);
    /// Null where the arm is another computer's.
    [[nodiscard]] const std::shared_ptr<OwnArm>& own_arm() const noexcept { return own_arm_; }

  private:
    ArmLine(std::unique_ptr<UdpSocket> socket, const ArmKey& key)
        : socket_(std::move(socket)), seal_(key) {}

    std::shared_ptr<OwnArm> own_arm_;
    std::string address_;
    std::string key_file_;
    std::unique_ptr<UdpSocket> socket_;
    SodiumSeal seal_;
    SodiumNumbers numbers_;
};

/// Greets each arm of a settled request, so that it is known which it is before anything is made for it: `arm_name`, and the process of an
/// arm at this computer. Refuses one that does not answer.
[[nodiscard]] Expected<void> meet_arms(RunRequest& request);

}  // namespace fulcrum::runtime
