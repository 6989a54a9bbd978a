#include "runtime/app/own_arm.h"

#include "haptics/base/clock.h"
#include "runtime/arms/dhd/dhd_port.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <sstream>
#include <utility>

namespace fulcrum::runtime {
namespace {

// The rest of a line that begins so; nothing of another.
std::optional<std::string_view> after(std::string_view line, std::string_view begin) {
    return line.starts_with(begin) ? std::optional(line.substr(begin.size())) : std::nullopt;
}

}  // namespace

const std::vector<std::string> kArmEnvironment{"HOME=", "XDG_", "GTDD_HOME=", "OH_SDK_BASE="};

// This program again, as the arm's side.
std::vector<std::string> arm_words(const OwnArmKind& kind) {
    std::error_code error;
    return {std::filesystem::read_symlink("/proc/self/exe", error).string(), "arm", "--attached",
            "--arm", std::string(kind.arm)};
}

std::vector<std::string> hear_beginning(LineProgram& program, double until_s) {
    std::vector<std::string> lines;
    bool is_last = false;
    while (!is_last && monotonic_now_s() < until_s) {
        auto line = program.wait(until_s - monotonic_now_s());
        if (!line) {
            break;
        }
        is_last = line->starts_with(kArmAt) || line->starts_with(kArmError);
        lines.push_back(std::move(*line));
    }
    return lines;
}

Expected<std::unique_ptr<OwnArm>> OwnArm::start(std::vector<std::string> words, std::string name) {
    std::unique_ptr<OwnArm> arm(new OwnArm(std::move(words), std::move(name)));
    return arm->begin().map([&] {
        OwnArm* const own = arm.get();
        own->watcher_ = std::jthread([own](const std::stop_token& ends) { own->watch(ends); });
        return std::move(arm);
    });
}

OwnArm::~OwnArm() {
    watcher_ = {};
    if (program_ != nullptr) {
        program_->finish(kArmFarewell_s);
    }
}

std::string OwnArm::address() const {
    return "127.0.0.1:" + std::to_string(port_);
}

std::string OwnArm::take_notice() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(notice_, {});
}

int OwnArm::n_restarts() {
    const std::scoped_lock lock(mutex_);
    return n_restarts_;
}

void OwnArm::tell(std::string_view sentence) {
    const std::scoped_lock lock(mutex_);
    constexpr std::size_t kMostTold = 2000;
    if (notice_.size() < kMostTold) {
        notice_ += (notice_.empty() ? "" : " ") + std::string(sentence);
    }
}

// Up to the line that says where it waits.
Expected<void> OwnArm::begin() {
    std::vector<std::string> words = words_;
    words.insert(words.end(), {"--port", std::to_string(port_)});
    words.insert(words.end(), words_again_.begin(), words_again_.end());
    // Somebody's yes was for now: whoever holds the arm when it is started again did not give it.
    std::erase(words_, kInitialiseOption);
    auto program = LineProgram::start(words, kArmEnvironment);
    if (!program) {
        return tl::unexpected(program.error());
    }
    for (const std::string& line : hear_beginning(**program, monotonic_now_s() + kArmBegin_s)) {
        if (const auto error = after(line, kArmError)) {
            (*program)->finish(kArmFarewell_s);
            return fail(name_ + ": " + std::string(*error));
        }
        if (const auto same = after(line, kArmSame); same && words_again_.empty()) {
            std::istringstream all{std::string(*same)};
            for (std::string word; all >> word;) {
                words_again_.push_back(word);
            }
        }
        if (const auto at = after(line, kArmAt)) {
            std::uint16_t port = 0;
            (void)std::from_chars(at->data(), at->data() + at->size(), port);
            port_ = port_ == 0 ? port : port_;
            program_ = std::move(*program);
            heard_s_ = monotonic_now_s();
            return {};
        }
    }
    const std::string why = (*program)->trouble();
    // It may be in a maker's library, with the arm: it is asked first.
    (*program)->finish(kArmFarewell_s);
    return fail(name_ + " does not begin: " + (why.empty() ? "its program says nothing" : why), {},
                "look at ./fulcrum devices");
}

void OwnArm::watch(const std::stop_token& ends) {
    constexpr double kLook_s = 0.05;
    double tried_s = 0.0;
    while (!ends.stop_requested()) {
        if (program_ != nullptr) {
            hear(kLook_s);
            continue;
        }
        const double now_s = monotonic_now_s();
        if (now_s - tried_s < kArmAgain_s) {
            std::this_thread::sleep_for(std::chrono::duration<double>(kLook_s));
            continue;
        }
        tried_s = now_s;
        if (const auto begun = begin(); begun) {
            is_gone_ = false;
            why_gone_.clear();
            tell(name_ + " is back.");
            const std::scoped_lock lock(mutex_);
            ++n_restarts_;
        } else if (std::string why = to_sentence(begun.error()); why != why_gone_) {
            tell(why);
            why_gone_ = std::move(why);
        }
    }
}

// A line, or the end of it.
void OwnArm::hear(double patience_s) {
    if (const auto line = program_->wait(patience_s)) {
        heard_s_ = monotonic_now_s();
        if (const auto told = after(*line, kArmTold)) {
            tell(*told);
        }
        return;
    }
    const bool is_silent = monotonic_now_s() - heard_s_ > kArmPatience_s;
    if (!program_->trouble().empty() || is_silent) {
        if (!std::exchange(is_gone_, true)) {
            tell(name_ + (is_silent ? " does not answer: its program is started again."
                                    : " has gone: its program is started again."));
        }
        program_->finish(kArmFrozen_s);
        program_.reset();
    }
}

}  // namespace fulcrum::runtime
