// MuJoCo: one free joint, with its semi-implicit Euler and its Runge-Kutta integrator.
#include "tests/bench/peers/mujoco_model.h"
#include "tests/bench/peers/rigid_peer.h"

#include <array>
#include <cstdio>

namespace fulcrum::bench {
namespace {

class MujocoBody final : public RigidPeer {
  public:
    MujocoBody(const Inertia& inertia, const RigidState& state, int integrator) {
        const Vector3& moments = inertia.moments_kg_m2;
        std::array<char, 512> xml{};
        std::snprintf(xml.data(), xml.size(),
                      "<mujoco><option gravity=\"0 0 0\"/><worldbody><body><freejoint/><inertial "
                      "pos=\"0 0 0\" mass=\"%.17g\" diaginertia=\"%.17g %.17g %.17g\"/></body>"
                      "</worldbody></mujoco>",
                      inertia.mass_kg, moments.x(), moments.y(), moments.z());
        model_ = load_mujoco_model(xml.data());
        model_->opt.integrator = integrator;
        data_ = mj_makeData(model_);
        const Quaternion& q = state.pose_W.orientation;
        for (int i = 0; i < 3; ++i) {
            data_->qpos[i] = state.pose_W.position[i];
            data_->qvel[i] = state.velocity_W.linear[i];
        }
        const std::array<double, 4> turned{q.w(), q.x(), q.y(), q.z()};
        std::copy(turned.begin(), turned.end(), data_->qpos + 3);
        // A free joint turns in the body's own frame.
        const Vector3 spin_B = q.conjugate() * state.velocity_W.angular;
        std::copy_n(spin_B.data(), 3, data_->qvel + 3);
    }
    ~MujocoBody() override {
        mj_deleteData(data_);
        mj_deleteModel(model_);
    }

    void step(const Wrench& wrench_W, double dt_s) override {
        constexpr int kBody = 1;  // 0 is the world
        mjtNum* const applied = data_->xfrc_applied + 6 * kBody;
        std::copy_n(wrench_W.force.data(), 3, applied);
        std::copy_n(wrench_W.torque.data(), 3, applied + 3);
        model_->opt.timestep = dt_s;
        mj_step(model_, data_);
    }
    [[nodiscard]] RigidState state() const override {
        const mjtNum* const q = data_->qpos;
        const Quaternion turned(q[3], q[4], q[5], q[6]);
        const Vector3 spin_B(data_->qvel[3], data_->qvel[4], data_->qvel[5]);
        return {{{q[0], q[1], q[2]}, turned},
                {{data_->qvel[0], data_->qvel[1], data_->qvel[2]}, turned * spin_B}};
    }

  private:
    mjModel* model_;
    mjData* data_;
};

MakeRigidPeer make_with(int integrator) {
    return [integrator](const Inertia& inertia, const RigidState& state) {
        return std::make_unique<MujocoBody>(inertia, state, integrator);
    };
}

const RigidPeerRegistration kEuler{"MuJoCo 2.2.2, Euler", make_with(mjINT_EULER)};
const RigidPeerRegistration kRungeKutta{"MuJoCo 2.2.2, RK4", make_with(mjINT_RK4)};

}  // namespace
}  // namespace fulcrum::bench
