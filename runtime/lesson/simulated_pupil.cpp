#include "runtime/lesson/simulated_pupil.h"

#include "dialogue/speech/text/text_recogniser.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

namespace fulcrum::runtime {

SimulatedPupil::SimulatedPupil(std::vector<std::string> lines, double thinking_s)
    : lines_(lines.begin(), lines.end()), thinking_s_(thinking_s) {}

SimulatedPupil::SimulatedPupil(const LearnerModel& model, double thinking_s)
    : model_(model), thinking_s_(thinking_s) {}

Expected<std::vector<std::string>> SimulatedPupil::read_lines(const std::string& path) {
    std::error_code ignored;
    std::ifstream file;
    if (std::filesystem::is_regular_file(path, ignored)) {
        file.open(path);
    }
    if (!file.is_open()) {
        return fail("the answers cannot be read", path,
                    "give --say a text file with one answer a line");
    }
    std::ostringstream text;
    text << file.rdbuf();
    return dialogue::script_lines(text.str());
}

Expected<std::optional<std::string>> SimulatedPupil::answer(double asked_at_s, double now_s,
                                                            const dialogue::Question& question,
                                                            const Verdict& verdict) {
    const bool already_answered = asked_at_s == answered_question_asked_at_s_;
    const bool has_nothing = !model_ && lines_.empty();
    if (already_answered || has_nothing || now_s - asked_at_s < thinking_s_) {
        return std::optional<std::string>();
    }
    if (!model_ && lines_.front().starts_with('?')) {
        return ask(now_s);
    }
    answered_question_asked_at_s_ = asked_at_s;
    spoke_at_s_ = now_s;
    if (model_) {
        return model_->answer(question, verdict).map([](std::string said) {
            return std::optional(std::move(said));
        });
    }
    std::string line = std::move(lines_.front());
    lines_.pop_front();
    return std::optional(std::move(line));
}

std::optional<std::string> SimulatedPupil::ask(double now_s) {
    constexpr double kPause_s = 3.0;
    if (lines_.empty() || !lines_.front().starts_with('?') || now_s - spoke_at_s_ < kPause_s) {
        return std::nullopt;
    }
    spoke_at_s_ = now_s;
    std::string line = lines_.front().substr(1);
    lines_.pop_front();
    return line;
}

}  // namespace fulcrum::runtime
