// Bullet in double precision: its discrete world on one free body, implicit gyroscopic term in the body's frame.
#include "tests/bench/peers/rigid_peer.h"

#include <btBulletDynamicsCommon.h>

namespace fulcrum::bench {
namespace {

btVector3 to_bullet(const Vector3& v) {
    return {v.x(), v.y(), v.z()};
}
Vector3 from_bullet(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}

class BulletBody final : public RigidPeer {
  public:
    BulletBody(const Inertia& inertia, const RigidState& state)
        : dispatcher_(&configuration_),
          world_(&dispatcher_, &broadphase_, &solver_, &configuration_) {
        world_.setGravity({0.0, 0.0, 0.0});
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
        world_.addRigidBody(body_.get());
    }
    ~BulletBody() override { world_.removeRigidBody(body_.get()); }

    void step(const Wrench& wrench_W, double dt_s) override {
        body_->applyCentralForce(to_bullet(wrench_W.force));
        body_->applyTorque(to_bullet(wrench_W.torque));
        world_.stepSimulation(dt_s, 0);
    }
    [[nodiscard]] RigidState state() const override {
        const btTransform& at = body_->getWorldTransform();
        const btQuaternion q = at.getRotation();
        return {
            {from_bullet(at.getOrigin()), Quaternion(q.w(), q.x(), q.y(), q.z())},
            {from_bullet(body_->getLinearVelocity()), from_bullet(body_->getAngularVelocity())}};
    }

  private:
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_;
    btEmptyShape shape_;
    std::unique_ptr<btRigidBody> body_;
};

const RigidPeerRegistration kBullet{"Bullet 3.24",
                                    [](const Inertia& inertia, const RigidState& state) {
                                        return std::make_unique<BulletBody>(inertia, state);
                                    }};

}  // namespace
}  // namespace fulcrum::bench
