#include "dialogue/speech/text/text_recogniser.h"

#include <algorithm>

namespace fulcrum::dialogue {

void TextRecogniser::type(std::string text) {
    if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
        return;
    }
    if (typed_.size() >= kMostTypedAnswers) {
        ++dropped_;
        return;
    }
    typed_.push_back(std::move(text));
}

Expected<bool> TextRecogniser::listen(std::shared_ptr<const TemplateSet> templates) {
    if (templates == nullptr) {
        return fail("there is nothing to listen for; compile a question first");
    }
    listening_ = true;
    if (!script_.empty()) {
        type(std::move(script_.front()));
        script_.pop_front();
    }
    return true;
}

std::vector<Hypothesis> TextRecogniser::poll() {
    if (!listening_ || typed_.empty()) {
        return {};
    }
    std::vector<Hypothesis> heard{{std::move(typed_.front()), 1.0}};
    typed_.pop_front();
    listening_ = false;
    return heard;
}

void TextRecogniser::stop() {
    listening_ = false;
    typed_.clear();
}

std::vector<std::string> script_lines(std::string_view text) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::size_t first = std::min(line.find_first_not_of(" \t\r"), line.size());
        line.remove_prefix(first);
        while (!line.empty() &&
               std::string_view(" \t\r").find(line.back()) != std::string_view::npos) {
            line.remove_suffix(1);
        }
        if (!line.empty() && line.front() != '#') {
            lines.emplace_back(line);
        }
    }
    return lines;
}

}  // namespace fulcrum::dialogue
