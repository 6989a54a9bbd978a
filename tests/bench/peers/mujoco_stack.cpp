// MuJoCo: stacks of boxes by its Newton solver, with contacts as soft as they are by default and as hard as its manual lets
// them be at this step: solref 2 ms, two steps.
#include "tests/bench/curves/rigid_stacks.h"
#include "tests/bench/peers/mujoco_model.h"

#include <algorithm>
#include <sstream>

namespace fulcrum::bench {
namespace {

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

class MujocoStack final : public StackEngine {
  public:
    MujocoStack(const StackScene& scene, bool is_hard)
        : model_(load_mujoco_model(describe(scene, is_hard))), data_(mj_makeData(model_)) {}
    ~MujocoStack() override {
        mj_deleteData(data_);
        mj_deleteModel(model_);
    }

    void step() override {
        mj_step(model_, data_);
        std::fill_n(data_->xfrc_applied, 6 * model_->nbody, 0.0);
    }
    [[nodiscard]] Vector3 place(int box) const override {
        const mjtNum* const at = data_->qpos + kPlaceNumbers * box;
        return {at[0], at[1], at[2]};
    }
    void push(int box, const Vector3& force_W) override {
        // The first body is the world.
        std::copy_n(force_W.data(), 3, data_->xfrc_applied + 6 * (box + 1));
    }
    void throw_from(int box, const Vector3& at_W, const Vector3& velocity_W) override {
        mjtNum* const at = data_->qpos + kPlaceNumbers * box;
        std::copy_n(at_W.data(), 3, at);
        std::fill_n(at + 3, 4, 0.0);
        at[3] = 1.0;
        mjtNum* const speed = data_->qvel + kSpeedNumbers * box;
        std::copy_n(velocity_W.data(), 3, speed);
        std::fill_n(speed + 3, 3, 0.0);
    }

  private:
    mjModel* model_;
    mjData* data_;
};

const StackPeerRegistration kSoft{"MuJoCo 2.2.2", [](const StackScene& scene) {
                                      return std::make_unique<MujocoStack>(scene, false);
                                  }};
const StackPeerRegistration kHard{"MuJoCo 2.2.2, solref 2 ms", [](const StackScene& scene) {
                                      return std::make_unique<MujocoStack>(scene, true);
                                  }};

}  // namespace
}  // namespace fulcrum::bench
