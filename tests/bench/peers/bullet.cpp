// Bullet in double precision: a free body and stacks of boxes.
#include "tests/bench/curves/rigid_stacks.h"
#include "tests/bench/peers/rigid_peer.h"

#include <btBulletDynamicsCommon.h>
#include <cmath>

namespace fulcrum::bench {
namespace {

btVector3 to_bullet(const Vector3& v) {
    return {v.x(), v.y(), v.z()};
}
Vector3 from_bullet(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}

// Its discrete world with all that it needs.
struct BulletWorld {
    explicit BulletWorld(double gravity_m_per_s2)
        : dispatcher(&configuration), discrete(&dispatcher, &broadphase, &solver, &configuration) {
        discrete.setGravity({0.0, -gravity_m_per_s2, 0.0});
    }
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher;
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld discrete;
};

// One free body, implicit gyroscopic term in the body's frame.
class BulletBody final : public RigidPeer {
  public:
    BulletBody(const Inertia& inertia, const RigidState& state) {
        const Quaternion& q = state.pose_W.orientation;
        btRigidBody::btRigidBodyConstructionInfo info(inertia.mass_kg, nullptr, &shape_,
                                                      to_bullet(inertia.moments_kg_m2));
        info.m_startWorldTransform =
            btTransform(btQuaternion(q.x(), q.y(), q.z(), q.w()), to_bullet(state.pose_W.position));
        body_ = std::make_unique<btRigidBody>(info);
        body_->setDamping(0.0, 0.0);
        body_->setFlags(BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY);
        body_->setActivationState(DISABLE_DEACTIVATION);
        body_->setLinearVelocity(to_bullet(state.velocity_W.linear));
        body_->setAngularVelocity(to_bullet(state.velocity_W.angular));
        world_.discrete.addRigidBody(body_.get());
    }
    ~BulletBody() override { world_.discrete.removeRigidBody(body_.get()); }

    void step(const Wrench& wrench_W, double dt_s) override {
        body_->applyCentralForce(to_bullet(wrench_W.force));
        body_->applyTorque(to_bullet(wrench_W.torque));
        world_.discrete.stepSimulation(dt_s, 0);
    }
    [[nodiscard]] RigidState state() const override {
        const btTransform& at = body_->getWorldTransform();
        const btQuaternion q = at.getRotation();
        return {
            {from_bullet(at.getOrigin()), Quaternion(q.w(), q.x(), q.y(), q.z())},
            {from_bullet(body_->getLinearVelocity()), from_bullet(body_->getAngularVelocity())}};
    }

  private:
    BulletWorld world_{0.0};
    btEmptyShape shape_;
    std::unique_ptr<btRigidBody> body_;
};

const RigidPeerRegistration kBullet{"Bullet 3.24",
                                    [](const Inertia& inertia, const RigidState& state) {
                                        return std::make_unique<BulletBody>(inertia, state);
                                    }};

// Stacks of boxes by its sequential impulses, ten rounds.
class BulletStack final : public StackEngine {
  public:
    explicit BulletStack(const StackScene& scene) : plane_(btVector3(0.0, 1.0, 0.0), 0.0) {
        add(0.0, plane_, Vector3::Zero());
        for (const StackBox& box : scene.boxes) {
            shapes_.push_back(std::make_unique<btBoxShape>(to_bullet(box.half_m)));
            // Its margin stands off by more than these boxes' accuracy.
            shapes_.back()->setMargin(0.0);
            add(box.mass_kg, *shapes_.back(), box.at_W);
        }
    }
    ~BulletStack() override {
        for (const auto& body : bodies_) {
            world_.discrete.removeRigidBody(body.get());
        }
    }

    void step() override { world_.discrete.stepSimulation(kStackStep_s, 0); }
    [[nodiscard]] Vector3 place(int box) const override {
        return from_bullet(body(box).getWorldTransform().getOrigin());
    }
    void push(int box, const Vector3& force_W) override {
        body(box).applyCentralForce(to_bullet(force_W));
    }
    void throw_from(int box, const Vector3& at_W, const Vector3& velocity_W) override {
        btTransform place;
        place.setIdentity();
        place.setOrigin(to_bullet(at_W));
        body(box).setWorldTransform(place);
        body(box).setInterpolationWorldTransform(place);
        body(box).setLinearVelocity(to_bullet(velocity_W));
        body(box).setAngularVelocity({0.0, 0.0, 0.0});
    }

  private:
    // The first is the ground.
    [[nodiscard]] btRigidBody& body(int box) const {
        return *bodies_[static_cast<std::size_t>(box) + 1];
    }
    void add(double mass_kg, btCollisionShape& shape, const Vector3& at_W) {
        btVector3 moments(0.0, 0.0, 0.0);
        if (mass_kg > 0.0) {
            shape.calculateLocalInertia(mass_kg, moments);
        }
        btRigidBody::btRigidBodyConstructionInfo info(mass_kg, nullptr, &shape, moments);
        info.m_friction = std::sqrt(kStackFriction);  // of two bodies the product
        info.m_startWorldTransform.setOrigin(to_bullet(at_W));
        bodies_.push_back(std::make_unique<btRigidBody>(info));
        bodies_.back()->setActivationState(DISABLE_DEACTIVATION);
        world_.discrete.addRigidBody(bodies_.back().get());
    }

    BulletWorld world_{9.81};
    btStaticPlaneShape plane_;
    std::vector<std::unique_ptr<btBoxShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

const StackPeerRegistration kBulletStack{
    "Bullet 3.24", [](const StackScene& scene) { return std::make_unique<BulletStack>(scene); }};

}  // namespace
}  // namespace fulcrum::bench
