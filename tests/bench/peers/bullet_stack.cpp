// Bullet in double precision: stacks of boxes by its sequential impulses, ten rounds.
#include "tests/bench/curves/rigid_stacks.h"

#include <btBulletDynamicsCommon.h>
#include <cmath>
#include <vector>

namespace fulcrum::bench {
namespace {

class BulletStack final : public StackEngine {
  public:
    explicit BulletStack(const StackScene& scene)
        : dispatcher_(&configuration_),
          world_(&dispatcher_, &broadphase_, &solver_, &configuration_),
          plane_(btVector3(0.0, 1.0, 0.0), 0.0) {
        world_.setGravity({0.0, -9.81, 0.0});
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
            world_.removeRigidBody(body.get());
        }
    }

    void step() override { world_.stepSimulation(kStackStep_s, 0); }
    [[nodiscard]] Vector3 place(int box) const override {
        const btVector3& at = body(box).getWorldTransform().getOrigin();
        return {at.x(), at.y(), at.z()};
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
    static btVector3 to_bullet(const Vector3& v) { return {v.x(), v.y(), v.z()}; }
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
        world_.addRigidBody(bodies_.back().get());
    }

    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_;
    btStaticPlaneShape plane_;
    std::vector<std::unique_ptr<btBoxShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

const StackPeerRegistration kBulletStack{
    "Bullet 3.24", [](const StackScene& scene) { return std::make_unique<BulletStack>(scene); }};

}  // namespace
}  // namespace fulcrum::bench
