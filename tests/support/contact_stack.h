// A stack of cubes as bare contact problems: each cube touches what is under it with the four corners of its lower face, the top
// of what is under it counts as a plane without end. No collision detection.
#pragma once

#include "haptics/constraint/contact_solver.h"
#include "haptics/math/length.h"
#include "haptics/math/rotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace fulcrum {

struct ContactStackSettings {
    int n_cubes = 10;
    double edge_m = 0.1;
    double mass_kg = 1.0;
    double top_mass_kg = 1.0;
    double friction = 0.6;
    double dt_s = 0.001;
    Vector3 gravity_W{0.0, -9.81, 0.0};
    double start_gap_m = 0.0;       ///< between cubes, before the first step
    double margin_m = 1.0e-3;       ///< contacts are told of below this gap
    double recovery_per_s = 100.0;  ///< how fast overlap is pushed apart
};

class ContactStack {
  public:
    ContactStack(const ContactStackSettings& stack, const ContactSolverSettings& solver)
        : settings_(stack),
          problem_(capacity_of(stack.n_cubes)),
          solver_(solver, capacity_of(stack.n_cubes)) {
        for (int i = 0; i < stack.n_cubes; ++i) {
            Cube cube;
            const bool top = i == stack.n_cubes - 1;
            cube.mass_kg = top ? stack.top_mass_kg : stack.mass_kg;
            cube.pose_W.position.y() = (i + 0.5) * stack.edge_m + (i + 1) * stack.start_gap_m;
            cubes_.push_back(cube);
        }
    }

    static ContactCapacity capacity_of(int n_cubes) { return {n_cubes, 4 * n_cubes, 0}; }

    /// Velocities before the step: gravity added, then the problem.
    void prepare() noexcept {
        problem_.clear();
        for (const Cube& cube : cubes_) {
            Vector6 free = cube.velocity_W;
            free.head<3>() += settings_.dt_s * settings_.gravity_W;
            problem_.add_body(
                cube.mass_kg,
                Matrix3::Identity() * (cube.mass_kg * settings_.edge_m * settings_.edge_m / 6.0),
                free);
        }
        for (std::size_t i = 0; i < cubes_.size(); ++i) {
            add_contacts(static_cast<int>(i));
        }
    }
    SolveReport solve() noexcept {
        problem_.set_settled(settled_);
        const SolveReport report = solver_.solve(problem_);
        settled_ = report.n_iterations == 0;
        return report;
    }
    void finish() noexcept {
        for (const ContactConstraint& contact : problem_.contacts()) {
            memory(contact.body_b, corner_[index_of(contact)]) = {contact.impulse_Ns,
                                                                  contact.slides};
        }
        std::size_t i = 0;
        for (const ConstrainedBody& body : problem_.bodies()) {
            Cube& cube = cubes_[i++];
            cube.velocity_W = body.velocity_W;
            cube.pose_W.position += settings_.dt_s * cube.velocity_W.head<3>();
            const Vector3 turn = settings_.dt_s * cube.velocity_W.tail<3>();
            cube.pose_W.orientation = compute_exp(turn) * cube.pose_W.orientation;
            cube.pose_W.orientation.normalize();
        }
    }
    SolveReport step() noexcept {
        prepare();
        const SolveReport report = solve();
        finish();
        return report;
    }

    /// Velocity of a cube: m/s and rad/s.
    [[nodiscard]] Vector6& velocity(int cube) { return cubes_[size(cube)].velocity_W; }
    [[nodiscard]] const Pose& pose(int cube) const { return cubes_[size(cube)].pose_W; }
    [[nodiscard]] ContactProblem& problem() { return problem_; }
    /// Sideways way of the cube that went furthest, metres.
    [[nodiscard]] double drift_m() const {
        double most = 0.0;
        for (const Cube& cube : cubes_) {
            most = std::max(most, std::hypot(cube.pose_W.position.x(), cube.pose_W.position.z()));
        }
        return most;
    }
    /// How far the cube that sank most lies under its place, metres.
    [[nodiscard]] double sunk_m() const {
        double most = 0.0;
        for (std::size_t i = 0; i < cubes_.size(); ++i) {
            most = std::max(most, (static_cast<double>(i) + 0.5) * settings_.edge_m -
                                      cubes_[i].pose_W.position.y());
        }
        return most;
    }
    [[nodiscard]] std::size_t n_cubes() const { return cubes_.size(); }

  private:
    struct Memory {
        Vector3 impulse_Ns{Vector3::Zero()};
        bool slides = false;
    };
    struct Cube {
        double mass_kg = 1.0;
        Pose pose_W{};
        Vector6 velocity_W{Vector6::Zero()};
        std::array<Memory, 4> memory{};
    };
    static std::size_t size(int i) { return static_cast<std::size_t>(i); }
    std::size_t index_of(const ContactConstraint& contact) noexcept {
        return static_cast<std::size_t>(&contact - problem_.contacts().data());
    }
    Memory& memory(int cube, std::size_t corner) { return cubes_[size(cube)].memory[corner]; }

    void add_contacts(int i) noexcept {
        const Cube& cube = cubes_[size(i)];
        const double half = 0.5 * settings_.edge_m;
        const bool on_ground = i == 0;
        const Pose below = on_ground ? Pose::at({0.0, -half, 0.0}) : cubes_[size(i - 1)].pose_W;
        const Vector3 normal = below.orientation * Vector3(Vector3::UnitY());
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const Vector3 local((corner & 1U) != 0 ? half : -half, -half,
                                (corner & 2U) != 0 ? half : -half);
            const Vector3 arm = cube.pose_W.orientation * local;
            const Vector3 point = cube.pose_W.position + arm;
            const double gap = normal.dot(point - below.position) - half;
            const Vector3 over = below.orientation.conjugate() * (point - below.position);
            const bool beside =
                !on_ground && std::max(std::abs(over.x()), std::abs(over.z())) > 2.0 * half;
            if (gap > settings_.margin_m || beside) {
                memory(i, corner) = {};
                continue;
            }
            ContactConstraint c;
            c.body_a = i - 1;
            c.body_b = i;
            c.arm_a = point - below.position;
            c.arm_b = arm;
            c.axes_W = make_contact_axes(normal);
            c.static_friction = c.dynamic_friction = settings_.friction;
            // A gap that rounding could have made is none.
            constexpr double kClosed_m = 1.0e-9;
            if (gap > kClosed_m) {
                c.target_m_per_s.x() = -gap / settings_.dt_s;
            } else if (gap < -kClosed_m) {
                c.target_m_per_s.x() = std::min(-gap * settings_.recovery_per_s, 0.5);
            }
            c.impulse_Ns = memory(i, corner).impulse_Ns;
            c.slides = memory(i, corner).slides;
            corner_[problem_.contacts().size()] = corner;
            problem_.add_contact(c);
        }
    }

    ContactStackSettings settings_;
    ContactProblem problem_;
    ContactSolver solver_;
    std::vector<Cube> cubes_;
    std::array<std::size_t, 4096> corner_{};
    bool settled_ = false;
};

}  // namespace fulcrum
