// fulcrum-wam [--port N] [--address A] [--key FILE]: serves the WAM at this computer to a lesson anywhere: ./fulcrum run gravity --hand wam:HOST.
//
// The one source that knows libbarrett, built only where its headers are (-DFULCRUM_WAM=ON), and as C++14, as they want. libbarrett is GPL:
// so is the program that is linked with it, which nobody here passes on.
#include "runtime/arms/wam/wam_server.h"

#include <barrett/products/product_manager.h>
#include <barrett/standard_main_function.h>
#include <barrett/systems.h>
#include <barrett/units.h>
#include <cstddef>
#include <cstdio>
#include <memory>

namespace {

// A block of libbarrett's diagram: the handle's place and turn in, the force at the handle out.
template <std::size_t DOF>
class HeldHandle : public barrett::systems::System {
    BARRETT_UNITS_TEMPLATE_TYPEDEFS(DOF);
    typename Output<cf_type>::Value* force_value_;  // before `force`, which sets it

  public:
    explicit HeldHandle(fulcrum::runtime::WamServer& server)
        : barrett::systems::System("Fulcrum"),
          force_value_(nullptr),
          position(this),
          turn(this),
          force(this, &force_value_),
          server_(server) {}
    virtual ~HeldHandle() { this->mandatoryCleanUp(); }
    HeldHandle(const HeldHandle&) = delete;
    HeldHandle& operator=(const HeldHandle&) = delete;

    Input<cp_type> position;
    Input<Eigen::Quaterniond> turn;
    Output<cf_type> force;

  protected:
    // libbarrett's control thread, once a round.
    virtual void operate() {
        const cp_type& at = position.getValue();
        const Eigen::Quaterniond& q = turn.getValue();
        server_.tell({{at[0], at[1], at[2]}, {q.w(), q.x(), q.y(), q.z()}});
        const fulcrum::runtime::WamForce wanted = server_.wanted();
        cf_type out(0.0);
        for (std::size_t i = 0; i < 3; ++i) {
            out[i] = wanted.force_N[i];
        }
        force_value_->setValue(out);
    }

  private:
    fulcrum::runtime::WamServer& server_;
};

}  // namespace

template <std::size_t DOF>
int wam_main(int argc, char** argv, barrett::ProductManager& pm, barrett::systems::Wam<DOF>& wam) {
    const std::unique_ptr<fulcrum::runtime::WamServer> server =
        fulcrum::runtime::WamServer::start(argc, argv, static_cast<int>(DOF));
    if (!server) {
        return 2;
    }
    HeldHandle<DOF> handle(*server);
    barrett::systems::ToolForceToJointTorques<DOF> torques;
    wam.gravityCompensate();
    barrett::systems::connect(wam.kinematicsBase.kinOutput, torques.kinInput);
    barrett::systems::connect(wam.toolPosition.output, handle.position);
    barrett::systems::connect(wam.toolOrientation.output, handle.turn);
    barrett::systems::connect(handle.force, torques.input);
    barrett::systems::connect(torques.output, wam.input);
    while (server->goes_on() && pm.getSafetyModule()->getMode() == barrett::SafetyModule::ACTIVE) {
    }
    // Without force, its weight still carried, until somebody who holds it lets it rest: it never moves by itself.
    barrett::systems::disconnect(wam.input);
    std::printf("Hold the arm and press Shift-idle.\n");
    (void)std::fflush(stdout);
    pm.getSafetyModule()->waitForMode(barrett::SafetyModule::IDLE);
    return 0;
}
