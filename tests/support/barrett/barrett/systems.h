// Stands in for libbarrett's header: a diagram of systems that the control thread of a WAM pulls through each round, 500 times a second, with
// a simulated arm instead of joints. A torque of the first three joints is the force at the handle: there is no Jacobian here.
// Source: libbarrett, systems/abstract/system.h (Input, Output, Value, operate), systems/helpers.h (connect, disconnect), systems/wam.h (its
// parts by name), systems/tool_force_to_joint_torques.h (kinInput, input, output).
#pragma once

#include <atomic>
#include <barrett/units.h>
#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>

namespace barrett {
namespace stand_in {

// The arm, in stand_in.cpp; numbers in the base frame of the WAM.
class Arm {
  public:
    Arm();
    ~Arm();
    void read(double (&position_m)[3], double (&turn_wxyz)[4]);
    void feel(const double (&force_N)[3]);

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

// Of the execution manager: who changes the diagram waits for the round.
inline std::recursive_mutex& diagram() {
    static std::recursive_mutex mutex;
    return mutex;
}
inline std::uint64_t& round() {
    static std::uint64_t count = 0;
    return count;
}

}  // namespace stand_in

namespace systems {

class System {
  public:
    explicit System(const std::string& /*name*/ = "") {}
    virtual ~System() = default;

    template <class T>
    class Output {
      public:
        class Value {
          public:
            void setValue(const T& value) { value_ = value; }

          private:
            friend class Output;
            T value_;
        };
        Output(System* parent, Value** value) : parent_(parent) { *value = &value_; }
        const T& pull() {
            parent_->update();
            return value_.value_;
        }

      private:
        System* parent_;
        Value value_;
    };

    template <class T>
    class Input {
      public:
        explicit Input(System* /*parent*/) {}
        const T& getValue() const {
            if (from == nullptr) {
                throw std::logic_error("the input is not connected");
            }
            return from->pull();
        }
        Output<T>* from = nullptr;
    };

  protected:
    virtual void operate() = 0;
    void mandatoryCleanUp() {
        const std::lock_guard<std::recursive_mutex> lock(stand_in::diagram());
    }

  private:
    void update() {
        if (done_ != stand_in::round()) {
            done_ = stand_in::round();
            operate();
        }
    }
    std::uint64_t done_ = 0;
};

template <class T>
void connect(System::Output<T>& output, System::Input<T>& input) {
    const std::lock_guard<std::recursive_mutex> lock(stand_in::diagram());
    input.from = &output;
}
template <class T>
void disconnect(System::Input<T>& input) {
    const std::lock_guard<std::recursive_mutex> lock(stand_in::diagram());
    input.from = nullptr;
}

struct Kinematics {};

// A system with one output, which the arm sets.
template <class T>
class Source : public System {
  public:
    Source() : output(this, &value) {}
    typename Output<T>::Value* value = nullptr;
    Output<T> output;

  protected:
    void operate() override {}
};
template <class T>
class KinematicsSource : public System {
  public:
    KinematicsSource() : kinOutput(this, &value) {}
    typename Output<T>::Value* value = nullptr;
    Output<T> kinOutput;

  protected:
    void operate() override {}
};

template <std::size_t DOF>
class ToolForceToJointTorques : public System {
    BARRETT_UNITS_TEMPLATE_TYPEDEFS(DOF);
    typename Output<jt_type>::Value* value_ = nullptr;

  public:
    ToolForceToJointTorques() : kinInput(this), input(this), output(this, &value_) {}
    Input<Kinematics> kinInput;
    Input<cf_type> input;
    Output<jt_type> output;

  protected:
    void operate() override {
        (void)kinInput.getValue();
        jt_type torque(0.0);
        for (std::size_t i = 0; i < 3; ++i) {
            torque[i] = input.getValue()[i];
        }
        value_->setValue(torque);
    }
};

template <std::size_t DOF>
class Wam {
    BARRETT_UNITS_TEMPLATE_TYPEDEFS(DOF);

  public:
    Wam() : input(nullptr), control_([this] { control(); }) {}
    ~Wam() {
        ends_ = true;
        control_.join();
    }
    void gravityCompensate(bool /*compensate*/ = true) {}

    KinematicsSource<Kinematics> kinematicsBase;
    Source<cp_type> toolPosition;
    Source<Eigen::Quaterniond> toolOrientation;
    System::Input<jt_type> input;

  private:
    void control() {
        while (!ends_) {
            step();
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
    }
    void step() {
        const std::lock_guard<std::recursive_mutex> lock(stand_in::diagram());
        double at[3];
        double turn[4];
        arm_.read(at, turn);
        cp_type position(0.0);
        for (std::size_t i = 0; i < 3; ++i) {
            position[i] = at[i];
        }
        toolPosition.value->setValue(position);
        toolOrientation.value->setValue(Eigen::Quaterniond(turn[0], turn[1], turn[2], turn[3]));
        ++stand_in::round();
        double force_N[3] = {0.0, 0.0, 0.0};
        if (input.from != nullptr) {
            for (std::size_t i = 0; i < 3; ++i) {
                force_N[i] = input.getValue()[i];
            }
        }
        arm_.feel(force_N);
    }

    stand_in::Arm arm_;
    std::atomic<bool> ends_{false};
    std::thread control_;  // last: it uses the others
};

}  // namespace systems
}  // namespace barrett
