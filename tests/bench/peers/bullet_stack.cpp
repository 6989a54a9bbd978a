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
          cube_(btVector3(kCubeHalf_m, kCubeHalf_m, kCubeHalf_m)),
          plane_(btVector3(0.0, 1.0, 0.0), 0.0) {
        world_.setGravity({0.0, -9.81, 0.0});
        // Its margin stands off by more than these cubes' accuracy.
        cube_.setMargin(0.0);
        add(0.0, plane_, 0.0);
        for (int i = 0; i < scene.n_cubes; ++i) {
            add(scene.mass_kg(i), cube_, scene.height_m(i));
        }
    }
    ~BulletStack() override {
        for (const auto& body : bodies_) {
            world_.removeRigidBody(body.get());
        }
    }

    void step() override { world_.stepSimulation(kStackStep_s, 0); }
    [[nodiscard]] Vector3 place(int cube) const override {
        const btVector3& at =
            bodies_[static_cast<std::size_t>(cube) + 1]->getWorldTransform().getOrigin();
        return {at.x(), at.y(), at.z()};
    }

  private:
    void add(double mass_kg, btCollisionShape& shape, double height_m) {
        btVector3 moments(0.0, 0.0, 0.0);
        if (mass_kg > 0.0) {
            shape.calculateLocalInertia(mass_kg, moments);
        }
        btRigidBody::btRigidBodyConstructionInfo info(mass_kg, nullptr, &shape, moments);
        info.m_friction = std::sqrt(kStackFriction);  // of two bodies the product
        info.m_startWorldTransform.setOrigin({0.0, height_m, 0.0});
        bodies_.push_back(std::make_unique<btRigidBody>(info));
        bodies_.back()->setActivationState(DISABLE_DEACTIVATION);
        world_.addRigidBody(bodies_.back().get());
    }

    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_;
    btBoxShape cube_;
    btStaticPlaneShape plane_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

const StackPeerRegistration kBulletStack{
    "Bullet 3.24", [](const StackScene& scene) { return std::make_unique<BulletStack>(scene); }};

}  // namespace
}  // namespace fulcrum::bench
