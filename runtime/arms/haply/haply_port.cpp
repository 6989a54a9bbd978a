#include "runtime/arms/haply/haply_port.h"

#include "runtime/arms/haply/force_proof.h"
#include "runtime/arms/haply/grip_hold.h"
#include "runtime/arms/haply/haply_frames.h"
#include "runtime/arms/haply/haply_judge.h"
#include "runtime/arms/haply/haply_session.h"
#include "runtime/arms/haply/haply_traits.h"
#include "runtime/arms/haply/haply_watch.h"
#include "runtime/arms/haply/rest_finder.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <pthread.h>
#include <sched.h>
#include <thread>

namespace fulcrum::runtime {
namespace {

constexpr double kAnswer_s = 0.01;  // for one state, then the next force goes all the same
constexpr double kLost_s = 0.5;  // of silence until the line is tried anew, and between two tries
constexpr double kTellSilence_s = 0.1;   // a shorter one is a fault, but no words
constexpr double kOpenPatience_s = 1.0;  // for each question, while somebody waits for the arm
// While nobody does: five questions, and who stops the arm waits for less than a second.
constexpr double kAgainPatience_s = 0.15;
constexpr double kRestPause_s = 0.005;
constexpr int kMostAtOnce = 32;  // answers that are heard in one round

// Below the haptic loop, as the threads of sticks; who is refused goes on without.
void raise_haply_priority() noexcept {
    constexpr int kPriority = 60;
    sched_param wanted{};
    wanted.sched_priority = kPriority;
    (void)pthread_setschedparam(pthread_self(), SCHED_FIFO, &wanted);
}

void sleep_haply_until(double monotonic_s) noexcept {
    const double whole_s = std::floor(monotonic_s);
    const timespec until{.tv_sec = static_cast<time_t>(whole_s),
                         .tv_nsec = static_cast<long>(1e9 * (monotonic_s - whole_s))};
    (void)::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr);
}

// Where the handle rests; streams zero forces meanwhile, for the service tells nothing by itself.
Expected<Vector3> find_haply_centre(HaplySession& session, double wait_s) {
    RestFinder finder;
    const double until_s = monotonic_now_s() + wait_s;
    while (monotonic_now_s() < until_s) {
        const double now_s = monotonic_now_s();
        HaplyMessage message;
        if (!session.send(Vector3::Zero(), session.word(), false, now_s + kAnswer_s)) {
            return fail("the Haply service has gone: " + session.why(), "", "start it anew");
        }
        const auto heard = session.receive(message, now_s + kOpenPatience_s);
        if (heard == HaplySession::Heard::gone || heard == HaplySession::Heard::nothing) {
            return fail("the Haply service does not answer", "", "start it anew");
        }
        const auto arm = std::ranges::find_if(
            message.arms, [&](const HaplyArm& one) { return one.id == session.arm().id; });
        const auto centre = arm != message.arms.end()
                                ? finder.step(arm->position_A, monotonic_now_s())
                                : std::nullopt;
        if (centre) {
            return *centre;
        }
        sleep_haply_until(now_s + kRestPause_s);
    }
    return fail("the handle of the Haply arm was never still", "",
                "hold it still in the middle of its space while the arm is opened");
}

class HaplyPort final : public ArmPort {
  public:
    HaplyPort(const HaplySettings& settings, std::unique_ptr<MessageLog> log,
              std::unique_ptr<HaplySession> session, const Vector3& centre_A)
        : settings_(settings),
          log_(std::move(log)),
          session_(std::move(session)),
          arm_(session_->arm()),
          centre_A_(centre_A),
          traits_(make_haply_traits(arm_)),
          facts_(list_haply_facts(arm_, session_->version(), session_->force_scale(), centre_A)),
          watch_(arm_, session_->force_scale(), session_->scale_path(), settings.port),
          proof_(session_->word(), kHaplyForce_N) {
        word_.store(proof_.word());
        thread_ = std::thread([this] { run(); });
    }
    ~HaplyPort() override { stop(); }

    void stop() noexcept override {
        {
            const std::scoped_lock lock(stop_mutex_);
            stops_.store(true);
        }
        stop_wanted_.notify_all();
        if (thread_.joinable()) {
            thread_.join();
        }
    }
    [[nodiscard]] const DeviceTraits& traits() const noexcept override { return traits_; }
    // A hand that is pushed trembles by more than any encoder's step within a second, and gives way to 1.5 N by more than one, as at the
    // other arms. Nothing is said of shaking: states are stamped as they come, and a late one looks like a jerk.
    [[nodiscard]] SensorLife sensor() const noexcept override {
        return {.trembles_within_s = 1.0, .moves_at_N = 1.5, .most_m_per_s2 = 0.0};
    }
    // Else the middle would be where the hand happens to rest then.
    [[nodiscard]] std::vector<std::string> words_again() const override {
        std::array<char, 80> centre{};
        (void)std::snprintf(centre.data(), centre.size(), "%.6f,%.6f,%.6f", centre_A_.x(),
                            centre_A_.y(), centre_A_.z());
        return {"--centre", centre.data()};
    }
    [[nodiscard]] std::vector<ArmFact> facts() const override {
        std::vector<ArmFact> all = facts_;
        all.emplace_back("haply force word", name_of(word_.load()));
        return all;
    }

  private:
    void run() noexcept;
    void stream();
    [[nodiscard]] bool do_round();
    [[nodiscard]] bool hear(double deadline_s);
    void take(const HaplyMessage& message, double now_s);
    void take_arm(const HaplyArm& arm, double now_s);
    void open_again();
    void leave() noexcept;
    void lose(const std::string& trouble);
    void complain(const std::string& trouble);
    void publish(bool is_there, Fault faults) noexcept;
    [[nodiscard]] bool pause(double seconds);

    HaplySettings settings_;
    std::unique_ptr<MessageLog> log_;
    std::unique_ptr<HaplySession> session_;
    HaplyArm arm_;  // as it was opened
    Vector3 centre_A_;
    DeviceTraits traits_;
    std::vector<ArmFact> facts_;
    // The thread's.
    HaplyWatch watch_;
    ForceProof proof_;
    GripHold grip_;
    HaplyStatus status_{};
    ArmSample newest_{};
    double heard_s_ = 0.0;
    int n_due_ = 0;        // answers that have not come
    std::string trouble_;  // what people were told last; empty: all is well

    std::atomic<ForceWord> word_{ForceWord::vector};
    std::atomic<bool> stops_{false};
    std::mutex stop_mutex_;
    std::condition_variable stop_wanted_;
    std::thread thread_;
};

void HaplyPort::run() noexcept {
    raise_haply_priority();
    while (!stops_.load()) {
        try {
            if (session_) {
                stream();
            } else {
                open_again();
            }
        } catch (...) {
            // Memory has run out. Without the session nothing is felt.
            publish(false, Fault::none);
            session_.reset();
        }
    }
    leave();
}

// Until the line is lost, or somebody stops.
void HaplyPort::stream() {
    status_ = session_->arm().status;
    heard_s_ = monotonic_now_s();
    n_due_ = 0;
    watch_.begin(session_->arm(), session_->force_scale(), heard_s_);
    proof_ = ForceProof(session_->word(), kHaplyForce_N);
    double next_s = heard_s_;
    while (!stops_.load()) {
        if (!do_round()) {
            const std::string& why = session_->why();
            lose("has lost its service, for " + (why.empty() ? "it does not answer" : why) +
                 ": it is looked for, or start the Haply Inverse Service anew");
            session_.reset();
            return;
        }
        // One round that was late is made up for, and no more.
        const double period_s = 1.0 / settings_.rate_Hz;
        next_s = std::max(next_s + period_s, monotonic_now_s() - period_s);
        sleep_haply_until(next_s);
    }
}

// One force, and the states that came; false where the line is of no more use.
bool HaplyPort::do_round() {
    // An answer that came too late for its own round is not to be taken for this one's.
    if (!hear(0.0)) {
        return false;
    }
    // Afterwards, for the age of an order is judged by it.
    const double now_s = monotonic_now_s();
    const bool may_push = newest_.is_there && watch_.change().empty();
    const Vector3 wanted_A = may_push ? haply_from_D(wanted_D(now_s).force) : Vector3::Zero();
    const Vector3 force_A = proof_.allow(wanted_A, now_s);
    if (!session_->send(force_A, proof_.word(), watch_.is_due(now_s), now_s + kAnswer_s)) {
        return false;
    }
    ++n_due_;
    proof_.note_sent(force_A, now_s);
    if (!hear(now_s + kAnswer_s)) {
        return false;
    }
    watch_.step();
    const double silent_s = monotonic_now_s() - heard_s_;
    if (silent_s > kTellSilence_s) {
        lose("does not answer: look whether the Haply Inverse Service still runs");
    } else if (silent_s > kArmSilence_s) {
        publish(false, Fault::none);
    }
    return silent_s <= kLost_s;
}

// Waits for as many answers as are due; who is still owed one then gets it no more, for another came behind it.
bool HaplyPort::hear(double deadline_s) {
    bool has_heard = false;
    const double until_s = std::max(deadline_s, monotonic_now_s() + kAnswer_s);
    for (int i = 0; i < kMostAtOnce && monotonic_now_s() < until_s; ++i) {
        HaplyMessage message;
        switch (session_->receive(message, n_due_ > 0 ? deadline_s : 0.0)) {
            case HaplySession::Heard::state:
                heard_s_ = monotonic_now_s();
                take(message, heard_s_);
                break;
            case HaplySession::Heard::nonsense:
                heard_s_ = monotonic_now_s();
                lose("cannot be understood: " + session_->why());
                break;
            case HaplySession::Heard::nothing:
                n_due_ = has_heard ? 0 : n_due_;
                return true;
            case HaplySession::Heard::gone:
                return false;
        }
        has_heard = deadline_s > 0.0;
        n_due_ = std::max(0, n_due_ - 1);
    }
    return true;
}

void HaplyPort::take(const HaplyMessage& message, double now_s) {
    const auto arm =
        std::ranges::find_if(message.arms, [&](const HaplyArm& one) { return one.id == arm_.id; });
    if (arm == message.arms.end()) {
        lose("has gone: plug it in again");
        return;
    }
    grip_.take(message.grips);
    take_arm(*arm, now_s);
}

void HaplyPort::take_arm(const HaplyArm& arm, double now_s) {
    update(status_, arm.status);
    watch_.note(arm, now_s);
    proof_.note_state(arm.position_A, arm.velocity_A, arm.echo_A, now_s);
    word_.store(proof_.word());
    newest_.pose_D = {haply_to_D(arm.position_A - centre_A_), haply_to_D(grip_.orientation_A())};
    newest_.buttons = grip_.buttons();
    if (!watch_.change().empty()) {
        lose("gives no more force, for somebody has changed " + watch_.change() +
             " in the Haply service: set it back in Haply Hub and start the arm again");
    } else if (const std::string trouble = find_haply_trouble(status_); !trouble.empty()) {
        lose(trouble);
    } else if (proof_.is_pushed_more()) {
        lose(
            "is pushed by more than is asked for here: close what else uses it in the Haply "
            "service");
    } else if (proof_.is_stuck()) {
        lose("tells the same again and again though it is pushed: unplug it and plug it in");
    } else if (proof_.verdict() == ForceProof::Verdict::refused) {
        complain(
            "takes no force from here, by neither word for it: install version 3.1 to 3.9 of the "
            "Haply Inverse Service");
        publish(true, Fault::device_write);
    } else {
        if (!std::exchange(trouble_, {}).empty()) {
            tell(traits_.name + " is back.");
        }
        publish(true, Fault::none);
    }
}

void HaplyPort::open_again() {
    if (pause(kLost_s)) {
        return;
    }
    auto session = HaplySession::open(settings_.port, arm_.id, kAgainPatience_s, *log_);
    if (!session) {
        lose("is not there: " + to_sentence(session.error()));
        return;
    }
    session_ = std::move(*session);
}

// Without force, and goodbye.
void HaplyPort::leave() noexcept {
    publish(false, Fault::none);
    if (!session_) {
        return;
    }
    try {
        HaplyMessage message;
        const double until_s = monotonic_now_s() + kAnswer_s;
        if (session_->send(Vector3::Zero(), proof_.word(), false, until_s)) {
            (void)session_->receive(message, until_s);
        }
    } catch (...) {
        // The session's end ends its force as well.
    }
    session_.reset();
}

void HaplyPort::lose(const std::string& trouble) {
    publish(false, Fault::none);
    complain(trouble);
}

// Once for each reason in a row.
void HaplyPort::complain(const std::string& trouble) {
    if (trouble_ != trouble) {
        trouble_ = trouble;
        tell(traits_.name + " " + trouble + (trouble.ends_with('.') ? "" : "."));
    }
}

void HaplyPort::publish(bool is_there, Fault faults) noexcept {
    newest_.is_there = is_there;
    newest_.faults = faults;
    newest_.stamp_s = heard_s_;
    sample.publish(newest_);
}

bool HaplyPort::pause(double seconds) {
    std::unique_lock lock(stop_mutex_);
    return stop_wanted_.wait_for(lock, std::chrono::duration<double>(seconds),
                                 [&] { return stops_.load(); });
}

}  // namespace

Expected<std::unique_ptr<ArmPort>> open_haply(const HaplySettings& settings) {
    if (auto good = validate(settings); !good) {
        return tl::unexpected<Error>(good.error());
    }
    auto log = std::make_unique<MessageLog>();
    if (!settings.log_file.empty()) {
        auto opened = MessageLog::open(settings.log_file);
        if (!opened) {
            return tl::unexpected<Error>(opened.error());
        }
        *log = std::move(*opened);
    }
    auto session = HaplySession::open(settings.port, settings.device_id, kOpenPatience_s, *log);
    if (!session) {
        return tl::unexpected<Error>(session.error());
    }
    const auto centre = settings.centre_A ? Expected<Vector3>(*settings.centre_A)
                                          : find_haply_centre(**session, settings.rest_wait_s);
    if (!centre) {
        return tl::unexpected<Error>(centre.error());
    }
    return std::unique_ptr<ArmPort>(
        std::make_unique<HaplyPort>(settings, std::move(log), std::move(*session), *centre));
}

}  // namespace fulcrum::runtime
