// ODE: a free body and stacks of boxes.
#include "tests/bench/curves/rigid_stacks.h"
#include "tests/bench/peers/rigid_peer.h"

#include <ode/ode.h>

namespace fulcrum::bench {
namespace {

Vector3 to_vector(const dReal* v) {
    return {v[0], v[1], v[2]};
}

// The library and a world in it, as long as this lives.
class OdeWorld {
  public:
    explicit OdeWorld(double gravity_m_per_s2) {
        dInitODE2(0);
        world_ = dWorldCreate();
        dWorldSetGravity(world_, 0.0, -gravity_m_per_s2, 0.0);
    }
    OdeWorld(const OdeWorld&) = delete;
    OdeWorld& operator=(const OdeWorld&) = delete;
    ~OdeWorld() {
        dWorldDestroy(world_);
        dCloseODE();
    }
    [[nodiscard]] dWorldID get() const { return world_; }

  private:
    dWorldID world_;
};

// Its exact (Dantzig) step on one free body, gyroscopic term on.
class OdeBody final : public RigidPeer {
  public:
    OdeBody(const Inertia& inertia, const RigidState& state) : body_(dBodyCreate(world_.get())) {
        dMass mass;
        const Vector3& moments = inertia.moments_kg_m2;
        dMassSetParameters(&mass, inertia.mass_kg, 0.0, 0.0, 0.0, moments.x(), moments.y(),
                           moments.z(), 0.0, 0.0, 0.0);
        dBodySetMass(body_, &mass);
        dBodySetGyroscopicMode(body_, 1);
        dBodySetAutoDisableFlag(body_, 0);
        const Vector3& x = state.pose_W.position;
        const Quaternion& q = state.pose_W.orientation;
        const Vector3& v = state.velocity_W.linear;
        const Vector3& w = state.velocity_W.angular;
        const dQuaternion turned{q.w(), q.x(), q.y(), q.z()};
        dBodySetPosition(body_, x.x(), x.y(), x.z());
        dBodySetQuaternion(body_, turned);
        dBodySetLinearVel(body_, v.x(), v.y(), v.z());
        dBodySetAngularVel(body_, w.x(), w.y(), w.z());
    }

    void step(const Wrench& wrench_W, double dt_s) override {
        const Vector3& f = wrench_W.force;
        const Vector3& t = wrench_W.torque;
        dBodyAddForce(body_, f.x(), f.y(), f.z());
        dBodyAddTorque(body_, t.x(), t.y(), t.z());
        dWorldStep(world_.get(), dt_s);
    }
    [[nodiscard]] RigidState state() const override {
        const dReal* q = dBodyGetQuaternion(body_);
        return {{to_vector(dBodyGetPosition(body_)), Quaternion(q[0], q[1], q[2], q[3])},
                {to_vector(dBodyGetLinearVel(body_)), to_vector(dBodyGetAngularVel(body_))}};
    }

  private:
    OdeWorld world_{0.0};
    dBodyID body_;
};

const RigidPeerRegistration kOde{"ODE 0.16.2", [](const Inertia& inertia, const RigidState& state) {
                                     return std::make_unique<OdeBody>(inertia, state);
                                 }};

// Stacks of boxes, by its exact step and by its quick step.
class OdeStack final : public StackEngine {
  public:
    OdeStack(const StackScene& scene, bool quick) : quick_(quick) {
        space_ = dHashSpaceCreate(nullptr);
        group_ = dJointGroupCreate(0);
        dWorldSetQuickStepNumIterations(world_.get(), 50);
        dCreatePlane(space_, 0.0, 1.0, 0.0, 0.0);
        for (const StackBox& box : scene.boxes) {
            const dBodyID body = dBodyCreate(world_.get());
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
    }

    void step() override {
        dSpaceCollide(space_, this, touch);
        if (quick_) {
            dWorldQuickStep(world_.get(), kStackStep_s);
        } else {
            dWorldStep(world_.get(), kStackStep_s);
        }
        dJointGroupEmpty(group_);
    }
    [[nodiscard]] Vector3 place(int box) const override {
        return to_vector(dBodyGetPosition(body(box)));
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
            dJointAttach(dJointCreateContact(stack.world_.get(), stack.group_, &contacts[i]),
                         dGeomGetBody(first), dGeomGetBody(second));
        }
    }

    bool quick_;
    OdeWorld world_{9.81};
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
