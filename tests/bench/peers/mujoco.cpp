// MuJoCo: a free body and stacks of boxes.
#include "tests/bench/curves/rigid_stacks.h"
#include "tests/bench/peers/rigid_peer.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <mujoco/mujoco.h>
#include <sstream>
#include <stdexcept>
#include <string>

namespace fulcrum::bench {
namespace {

// Throws where the text is no model.
mjModel* load_mujoco_model(const std::string& text) {
    // Left alone, MuJoCo writes its words into a log file where it was started. A run out of bounds is seen by its
    // error; from an error MuJoCo must not return.
    mju_user_warning = [](const char*) {};
    mju_user_error = [](const char* message) {
        std::fprintf(stderr, "MuJoCo: %s\n", message);
        std::exit(1);
    };
    const auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    mj_makeEmptyFileVFS(files.get(), "body.xml", static_cast<int>(text.size()));
    std::copy(text.begin(), text.end(), static_cast<char*>(files->filedata[files->nfile - 1]));
    std::array<char, 500> error{};
    mjModel* const model = mj_loadXML("body.xml", files.get(), error.data(), error.size());
    mj_deleteVFS(files.get());
    if (model == nullptr) {
        throw std::runtime_error(error.data());
    }
    return model;
}

// A model and its state, as long as this lives.
class MujocoScene {
  public:
    explicit MujocoScene(const std::string& text)
        : model(load_mujoco_model(text)), data(mj_makeData(model)) {}
    MujocoScene(const MujocoScene&) = delete;
    MujocoScene& operator=(const MujocoScene&) = delete;
    ~MujocoScene() {
        mj_deleteData(data);
        mj_deleteModel(model);
    }
    mjModel* const model;
    mjData* const data;
};

std::string describe(const Inertia& inertia) {
    const Vector3& moments = inertia.moments_kg_m2;
    std::array<char, 512> xml{};
    std::snprintf(xml.data(), xml.size(),
                  "<mujoco><option gravity=\"0 0 0\"/><worldbody><body><freejoint/><inertial "
                  "pos=\"0 0 0\" mass=\"%.17g\" diaginertia=\"%.17g %.17g %.17g\"/></body>"
                  "</worldbody></mujoco>",
                  inertia.mass_kg, moments.x(), moments.y(), moments.z());
    return xml.data();
}

// One free joint, with its semi-implicit Euler and its Runge-Kutta integrator.
class MujocoBody final : public RigidPeer {
  public:
    MujocoBody(const Inertia& inertia, const RigidState& state, int integrator)
        : scene_(describe(inertia)) {
        scene_.model->opt.integrator = integrator;
        const Quaternion& q = state.pose_W.orientation;
        for (int i = 0; i < 3; ++i) {
            scene_.data->qpos[i] = state.pose_W.position[i];
            scene_.data->qvel[i] = state.velocity_W.linear[i];
        }
        const std::array<double, 4> turned{q.w(), q.x(), q.y(), q.z()};
        std::copy(turned.begin(), turned.end(), scene_.data->qpos + 3);
        // A free joint turns in the body's own frame.
        const Vector3 spin_B = q.conjugate() * state.velocity_W.angular;
        std::copy_n(spin_B.data(), 3, scene_.data->qvel + 3);
    }

    void step(const Wrench& wrench_W, double dt_s) override {
        constexpr int kBody = 1;  // 0 is the world
        mjtNum* const applied = scene_.data->xfrc_applied + 6 * kBody;
        std::copy_n(wrench_W.force.data(), 3, applied);
        std::copy_n(wrench_W.torque.data(), 3, applied + 3);
        scene_.model->opt.timestep = dt_s;
        mj_step(scene_.model, scene_.data);
    }
    [[nodiscard]] RigidState state() const override {
        const mjtNum* const q = scene_.data->qpos;
        const Quaternion turned(q[3], q[4], q[5], q[6]);
        const Vector3 spin_B(scene_.data->qvel[3], scene_.data->qvel[4], scene_.data->qvel[5]);
        return {
            {{q[0], q[1], q[2]}, turned},
            {{scene_.data->qvel[0], scene_.data->qvel[1], scene_.data->qvel[2]}, turned * spin_B}};
    }

  private:
    MujocoScene scene_;
};

MakeRigidPeer make_with(int integrator) {
    return [integrator](const Inertia& inertia, const RigidState& state) {
        return std::make_unique<MujocoBody>(inertia, state, integrator);
    };
}

const RigidPeerRegistration kEuler{"MuJoCo 2.2.2, Euler", make_with(mjINT_EULER)};
const RigidPeerRegistration kRungeKutta{"MuJoCo 2.2.2, RK4", make_with(mjINT_RK4)};

// Positions and a quaternion, velocities and spins.
constexpr int kPlaceNumbers = 7;
constexpr int kSpeedNumbers = 6;
constexpr std::size_t kMostTouching = 20;
constexpr std::size_t kMostRows = 4 * kMostTouching;

std::string describe(const StackScene& scene, bool is_hard) {
    std::ostringstream xml;
    xml << "<mujoco><option timestep=\"" << kStackStep_s
        << "\" gravity=\"0 -9.81 0\"/>"
        // Some twelve contacts a box, four rows each; it keeps a matrix of all rows.
        << "<size njmax=\"" << kMostRows * scene.boxes.size() << "\" nconmax=\""
        << kMostTouching * scene.boxes.size() << "\"/>"
        << "<default><geom condim=\"3\" friction=\"" << kStackFriction << "\""
        << (is_hard ? " solref=\"0.002 1\"" : "")
        << "/></default><worldbody>"
        // Its plane looks along z.
        << "<geom type=\"plane\" size=\"0 0 1\" zaxis=\"0 1 0\"/>";
    for (const StackBox& box : scene.boxes) {
        xml << "<body pos=\"" << box.at_W.x() << ' ' << box.at_W.y() << ' ' << box.at_W.z()
            << "\"><freejoint/><geom type=\"box\" size=\"" << box.half_m.x() << ' '
            << box.half_m.y() << ' ' << box.half_m.z() << "\" mass=\"" << box.mass_kg
            << "\"/></body>";
    }
    xml << "</worldbody></mujoco>";
    return xml.str();
}

// Stacks of boxes by its Newton solver, with contacts as soft as they are by default and as hard as its manual lets them be at this step:
// solref 2 ms, two steps.
class MujocoStack final : public StackEngine {
  public:
    MujocoStack(const StackScene& scene, bool is_hard) : scene_(describe(scene, is_hard)) {}

    void step() override {
        mj_step(scene_.model, scene_.data);
        std::fill_n(scene_.data->xfrc_applied, 6 * scene_.model->nbody, 0.0);
    }
    [[nodiscard]] Vector3 place(int box) const override {
        const mjtNum* const at = scene_.data->qpos + kPlaceNumbers * box;
        return {at[0], at[1], at[2]};
    }
    void push(int box, const Vector3& force_W) override {
        // The first body is the world.
        std::copy_n(force_W.data(), 3, scene_.data->xfrc_applied + 6 * (box + 1));
    }
    void throw_from(int box, const Vector3& at_W, const Vector3& velocity_W) override {
        mjtNum* const at = scene_.data->qpos + kPlaceNumbers * box;
        std::copy_n(at_W.data(), 3, at);
        std::fill_n(at + 3, 4, 0.0);
        at[3] = 1.0;
        mjtNum* const speed = scene_.data->qvel + kSpeedNumbers * box;
        std::copy_n(velocity_W.data(), 3, speed);
        std::fill_n(speed + 3, 3, 0.0);
    }

  private:
    MujocoScene scene_;
};

const StackPeerRegistration kSoft{"MuJoCo 2.2.2", [](const StackScene& scene) {
                                      return std::make_unique<MujocoStack>(scene, false);
                                  }};
const StackPeerRegistration kHard{"MuJoCo 2.2.2, solref 2 ms", [](const StackScene& scene) {
                                      return std::make_unique<MujocoStack>(scene, true);
                                  }};

}  // namespace
}  // namespace fulcrum::bench
