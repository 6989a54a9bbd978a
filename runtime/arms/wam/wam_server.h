// Barrett's WAM served over the link (PROTOCOL.md) at its own computer: between libbarrett's control thread and an ArmServer.
//
//   p_D = (y, z, x)_A    q_D = (w, y, z, x)_A    f_A = (f_z, f_x, f_y)_D     A, the WAM's base: +X ahead of it, +Y left, +Z up
// The pupil stands opposite, and the middle of the scene is where the handle was when it began. libbarrett carries the arm's weight. A
// control thread that stops lets the pose grow old, and the gate fades; a server that stops lets the order grow old, and the control thread
// has no force kArmSilence_s later. No torque is given.
//
// This header alone is read together with libbarrett's own, which want C++14: plain numbers, nothing of C++20.
//
// Thread: `tell` and `wanted` on libbarrett's control thread, without lock or allocation; the rest on the main thread. Cost: two hand-overs.
// Source: libbarrett, systems/wam.h (tool position, orientation and kinematics); the frame is that of haptics/device/arm/simulated_wam.h.
#pragma once

#include <memory>

namespace fulcrum {
namespace runtime {

/// The handle in the WAM's base frame A.
struct WamPose {
    double position_m[3];
    double turn_wxyz[4];
};

/// In frame A.
struct WamForce {
    double force_N[3];
};

class WamServer {
  public:
    /// Reads the words of the command line: --port N (4701), --address A (127.0.0.1), --key FILE, --force-limit N (5). Null, and a sentence on the terminal, where they are
    /// wrong or nothing can be served there. `n_joints`: of the WAM, for its name.
    static std::unique_ptr<WamServer> start(int argc, char** argv, int n_joints);
    WamServer(const WamServer&) = delete;
    WamServer& operator=(const WamServer&) = delete;
    ~WamServer();

    /// Where the handle is now. The first is the middle.
    void tell(const WamPose& pose) noexcept;
    /// What the arm is to give until the next round.
    WamForce wanted() noexcept;
    /// False once somebody wants it to end; else, after a while, true.
    bool goes_on();

  private:
    struct Parts;
    explicit WamServer(std::unique_ptr<Parts> parts);

    std::unique_ptr<Parts> parts_;
};

}  // namespace runtime
}  // namespace fulcrum
