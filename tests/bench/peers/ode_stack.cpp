// ODE: stacks of boxes, by its exact (Dantzig) step and by its quick step.
#include "tests/bench/curves/rigid_stacks.h"

#include <ode/ode.h>
#include <vector>

namespace fulcrum::bench {
namespace {

class OdeStack final : public StackEngine {
  public:
    OdeStack(const StackScene& scene, bool quick) : quick_(quick) {
        dInitODE2(0);
        world_ = dWorldCreate();
        space_ = dHashSpaceCreate(nullptr);
        group_ = dJointGroupCreate(0);
        dWorldSetGravity(world_, 0.0, -9.81, 0.0);
        dWorldSetQuickStepNumIterations(world_, 50);
        dCreatePlane(space_, 0.0, 1.0, 0.0, 0.0);
        for (const StackBox& box : scene.boxes) {
            const dBodyID body = dBodyCreate(world_);
            const Vector3 edges_m = 2.0 * box.half_m;
            dMass mass;
            dMassSetBoxTotal(&mass, box.mass_kg, edges_m.x(), edges_m.y(), edges_m.z());
            dBodySetMass(body, &mass);
            dBodySetAutoDisableFlag(body, 0);
            dBodySetPosition(body, box.at_W.x(), box.at_W.y(), box.at_W.z());
            dGeomSetBody(dCreateBox(space_, edges_m.x(), edges_m.y(), edges_m.z()), body);
            bodies_.push_back(body);
        }
    }
    ~OdeStack() override {
        dJointGroupDestroy(group_);
        dSpaceDestroy(space_);
        dWorldDestroy(world_);
        dCloseODE();
    }

    void step() override {
        dSpaceCollide(space_, this, touch);
        if (quick_) {
            dWorldQuickStep(world_, kStackStep_s);
        } else {
            dWorldStep(world_, kStackStep_s);
        }
        dJointGroupEmpty(group_);
    }
    [[nodiscard]] Vector3 place(int box) const override {
        const dReal* at = dBodyGetPosition(body(box));
        return {at[0], at[1], at[2]};
    }
    void push(int box, const Vector3& force_W) override {
        dBodyAddForce(body(box), force_W.x(), force_W.y(), force_W.z());
    }
    void throw_from(int box, const Vector3& at_W, const Vector3& velocity_W) override {
        constexpr dQuaternion kUpright = {1.0, 0.0, 0.0, 0.0};
        dBodySetPosition(body(box), at_W.x(), at_W.y(), at_W.z());
        dBodySetQuaternion(body(box), kUpright);
        dBodySetLinearVel(body(box), velocity_W.x(), velocity_W.y(), velocity_W.z());
        dBodySetAngularVel(body(box), 0.0, 0.0, 0.0);
    }

  private:
    [[nodiscard]] dBodyID body(int box) const { return bodies_[static_cast<std::size_t>(box)]; }
    static void touch(void* self, dGeomID first, dGeomID second) {
        auto& stack = *static_cast<OdeStack*>(self);
        constexpr int kMost = 8;
        dContact contacts[kMost];
        const int n = dCollide(first, second, kMost, &contacts[0].geom, sizeof(dContact));
        for (int i = 0; i < n; ++i) {
            contacts[i].surface.mode = dContactApprox1;
            contacts[i].surface.mu = kStackFriction;
            dJointAttach(dJointCreateContact(stack.world_, stack.group_, &contacts[i]),
                         dGeomGetBody(first), dGeomGetBody(second));
        }
    }

    bool quick_;
    dWorldID world_;
    dSpaceID space_;
    dJointGroupID group_;
    std::vector<dBodyID> bodies_;
};

const StackPeerRegistration kExact{"ODE 0.16.2 step", [](const StackScene& scene) {
                                       return std::make_unique<OdeStack>(scene, false);
                                   }};
const StackPeerRegistration kQuick{"ODE 0.16.2 quick step, 50", [](const StackScene& scene) {
                                       return std::make_unique<OdeStack>(scene, true);
                                   }};

}  // namespace
}  // namespace fulcrum::bench
