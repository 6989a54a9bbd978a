#include "dialogue/speech/external/hearing_lines.h"

#include "dialogue/speech/external/json_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace fulcrum::dialogue {
namespace {

constexpr std::string_view kLetters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

// RFC 4648, section 4.
std::string to_base64(const std::vector<std::int16_t>& samples) {
    std::string bytes;
    for (const std::int16_t sample : samples) {
        const auto bits = static_cast<std::uint16_t>(sample);
        bytes += static_cast<char>(bits & 0xFFU);
        bytes += static_cast<char>(bits >> 8U);
    }
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t three = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            three = three << 8U | (k < n ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            text += k <= n ? kLetters[three >> (18U - 6U * k) & 0x3FU] : '=';
        }
    }
    return text;
}

std::optional<std::vector<std::int16_t>> from_base64(std::string_view text) {
    if (text.size() % 4 != 0) {
        return {};
    }
    std::string bytes;
    for (std::size_t i = 0; i < text.size(); i += 4) {
        const bool is_last = i + 4 == text.size();
        const std::size_t n_pads =
            is_last ? static_cast<std::size_t>(std::ranges::count(text.substr(i), '=')) : 0;
        std::uint32_t three = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t value = k < 4 - n_pads ? kLetters.find(text[i + k]) : 0;
            if (value == std::string_view::npos) {
                return {};
            }
            three = three << 6U | static_cast<std::uint32_t>(value);
        }
        if (n_pads > 2) {
            return {};
        }
        for (std::size_t k = 0; k < 3 - n_pads; ++k) {
            bytes += static_cast<char>(three >> (16U - 8U * k) & 0xFFU);
        }
    }
    if (bytes.size() % 2 != 0) {
        return {};
    }
    std::vector<std::int16_t> samples(bytes.size() / 2);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto low = static_cast<unsigned char>(bytes[2 * i]);
        const auto high = static_cast<unsigned char>(bytes[2 * i + 1]);
        samples[i] = static_cast<std::int16_t>(static_cast<std::uint16_t>(high << 8U | low));
    }
    return samples;
}

std::optional<std::vector<std::string>> texts_of(const Json& object, const char* key) {
    const auto found = object.find(key);
    if (found == object.end() || !found->is_array() ||
        !std::ranges::all_of(*found, [](const Json& each) { return each.is_string(); })) {
        return {};
    }
    return found->get<std::vector<std::string>>();
}

std::optional<WordGraph::Arc> read_arc(const Json& arc) {
    const bool is_arc = arc.is_array() && arc.size() == 4 && arc[0].is_number_integer() &&
                        arc[1].is_number_integer() && arc[2].is_number_integer() &&
                        arc[3].is_number();
    if (!is_arc) {
        return {};
    }
    std::array<int, 3> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto value = arc[i].get<std::int64_t>();
        if (value < -1 || value > static_cast<std::int64_t>(kLongestLine_bytes)) {
            return {};
        }
        numbers[i] = static_cast<int>(value);
    }
    return WordGraph::Arc{numbers[0], numbers[1], numbers[2], arc[3].get<double>()};
}

std::optional<WordGraph> read_graph(const Json& object) {
    const auto words = texts_of(object, "words");
    const auto nodes = whole_number(object, "nodes");
    const auto arcs = object.find("arcs");
    if (!words || !nodes || arcs == object.end() || !arcs->is_array() ||
        *nodes > static_cast<int>(kLongestLine_bytes)) {
        return {};
    }
    WordGraph graph;
    graph.words = *words;
    graph.nodes = *nodes;
    for (const Json& each : *arcs) {
        const auto arc = read_arc(each);
        if (!arc) {
            return {};
        }
        graph.arcs.push_back(*arc);
    }
    return graph;
}

}  // namespace

Expected<HearingOrder> read_order(std::string_view line) {
    const Json object = parse_line(line, kLongestLine_bytes);
    if (const auto question = whole_number(object, "listen")) {
        auto graph = read_graph(object);
        return graph ? Expected<HearingOrder>(ListenLine{*question, std::move(*graph)})
                     : Expected<HearingOrder>(fail("the line to listen has no whole graph"));
    }
    if (const auto question = whole_number(object, "audio")) {
        auto samples = from_base64(text_of(object, "pcm").value_or("?"));
        return samples ? Expected<HearingOrder>(AudioLine{*question, std::move(*samples)})
                       : Expected<HearingOrder>(fail("the line of audio has no whole samples"));
    }
    if (const auto question = whole_number(object, "end")) {
        return EndLine{*question};
    }
    if (const auto question = whole_number(object, "stop")) {
        return StopLine{*question};
    }
    return fail("the line is none of listen, audio, end and stop");
}

std::string write_line(const HearingOrder& order) {
    Json object;
    if (const auto* const listen = std::get_if<ListenLine>(&order)) {
        object = {{"listen", listen->question},
                  {"words", listen->graph.words},
                  {"nodes", listen->graph.nodes},
                  {"arcs", Json::array()}};
        for (const WordGraph::Arc& arc : listen->graph.arcs) {
            object["arcs"].push_back({arc.from, arc.to, arc.word, arc.weight});
        }
    } else if (const auto* const audio = std::get_if<AudioLine>(&order)) {
        object = {{"audio", audio->question}, {"pcm", to_base64(audio->samples)}};
    } else if (const auto* const end = std::get_if<EndLine>(&order)) {
        object = {{"end", end->question}};
    } else {
        object = {{"stop", std::get<StopLine>(order).question}};
    }
    return to_text(object);
}

Expected<HearingAnswer> read_answer(std::string_view line) {
    const Json object = parse_line(line, kLongestLine_bytes);
    if (whole_number(object, "ready") == 1) {
        const auto form = object.find("form");
        const bool hears_form = form == object.end() || !form->is_boolean() || form->get<bool>();
        return ReadyLine{text_of(object, "name").value_or(""), hears_form};
    }
    if (const auto question = whole_number(object, "listening")) {
        return ListeningLine{*question,
                             texts_of(object, "unknown").value_or(std::vector<std::string>{})};
    }
    if (const auto question = whole_number(object, "heard")) {
        const auto text = text_of(object, "text");
        const auto confidence = object.find("confidence");
        if (!text || confidence == object.end() || !confidence->is_number()) {
            return fail("the line of what was heard has no text or confidence");
        }
        const auto sure = confidence->get<double>();
        const auto throat = object.find("throat");
        const double size =
            throat != object.end() && throat->is_number() ? throat->get<double>() : 0.0;
        constexpr double kLargest = 2.0;
        return HeardLine{*question, *text, std::isfinite(sure) ? std::clamp(sure, 0.0, 1.0) : 0.0,
                         size >= 1.0 && size <= kLargest ? size : 0.0};
    }
    if (auto sentence = text_of(object, "trouble")) {
        return TroubleLine{std::move(*sentence)};
    }
    return fail("the line is none of ready, listening, heard and trouble");
}

std::string write_line(const HearingAnswer& answer) {
    Json object;
    if (const auto* const ready = std::get_if<ReadyLine>(&answer)) {
        object = {{"ready", 1}, {"name", ready->name}, {"form", ready->form}};
    } else if (const auto* const listening = std::get_if<ListeningLine>(&answer)) {
        object = {{"listening", listening->question}, {"unknown", listening->unknown}};
    } else if (const auto* const heard = std::get_if<HeardLine>(&answer)) {
        object = {
            {"heard", heard->question}, {"text", heard->text}, {"confidence", heard->confidence}};
        if (heard->throat > 0.0) {
            object["throat"] = heard->throat;
        }
    } else {
        object = {{"trouble", std::get<TroubleLine>(answer).sentence}};
    }
    return to_text(object);
}

}  // namespace fulcrum::dialogue
