#include "runtime/app/run_recorder.h"

#include "runtime/app/tool_lacks.h"
#include "runtime/evidence/record_words.h"

#include <algorithm>

namespace fulcrum::runtime {
namespace {

RecordEventKind record_kind(WorldEvent::Kind kind) {
    return kind == WorldEvent::Kind::caught ? RecordEventKind::caught : RecordEventKind::landed;
}

RecordEventKind record_kind(WorldCommand::Kind kind) {
    switch (kind) {
        case WorldCommand::Kind::place:
            return RecordEventKind::placed;
        case WorldCommand::Kind::hide:
            return RecordEventKind::hidden;
        case WorldCommand::Kind::hold:
            return RecordEventKind::held;
        case WorldCommand::Kind::release:
            return RecordEventKind::released;
        case WorldCommand::Kind::drop:
            break;
    }
    return RecordEventKind::dropped;
}

bool is_same(const BodyState& a, const BodyState& b) {
    return a.where == b.where && is_same(a.pose_W, b.pose_W) && a.velocity_W == b.velocity_W;
}

}  // namespace

Expected<std::unique_ptr<RunRecorder>> RunRecorder::create(
    const std::string& file, const RecordHeader& header, std::span<HapticChannels* const> channels,
    std::vector<std::string> forces) {
    std::unique_ptr<RunRecorder> recorder(
        new RunRecorder(std::move(forces), static_cast<int>(header.bodies.size())));
    if (!file.empty()) {
        auto writer = RecordWriter::create(file, header);
        if (!writer) {
            return tl::unexpected(writer.error());
        }
        recorder->writer_.emplace(std::move(*writer));
    }
    for (HapticChannels* const hand : channels) {
        recorder->hands_.push_back(std::make_unique<Hand>());
        hand->record = &recorder->hands_.back()->ring;
    }
    return recorder;
}

void RunRecorder::keep_told(std::span<HapticChannels* const> channels) {
    for (std::size_t i = 0; i < std::min(channels.size(), hands_.size()); ++i) {
        hands_[i]->told = std::make_unique<ToldRings>(*channels[i]);
        channels[i]->told = hands_[i]->told.get();
    }
}

void RunRecorder::note(const Expected<void>& written) {
    if (!written && trouble_) {
        trouble_ = written;
    }
}

template <class Part>
void RunRecorder::write(const Part& part) {
    if (writer_) {
        note(writer_->append(part));
    }
}

void RunRecorder::keep(double time_s, RecordEventKind kind, std::int32_t body,
                       const std::string& text) {
    write(RecordEvent{time_s, kind, body, text});
}

void RunRecorder::drain() {
    for (std::size_t i = 0; i < hands_.size(); ++i) {
        drain(i);
    }
}

// Every round, and where the gate or a fault has changed, that too: who reads events alone must not miss it.
void RunRecorder::drain(std::size_t number) {
    Hand& hand = *hands_[number];
    if (hand.told && writer_) {
        hand.told->drain([&](const auto& told) { note(writer_->append(number, told)); });
    }
    const std::string whose = number == 0 ? "" : "hand " + std::to_string(number + 1) + ": ";
    for (RecordRound round; hand.ring.pop(round);) {
        const RecordSample& sample = round.sample;
        if (writer_) {
            note(writer_->append(number, round));
        }
        if (hand.check) {
            hand.check->take(round);
        }
        if (sample.faults != hand.faults) {
            hand.faults = sample.faults;
            keep(sample.time_s, RecordEventKind::fault, kNoBody, whose + fault_words(hand.faults));
        }
        if (sample.gate != hand.gate) {
            hand.gate = sample.gate;
            keep(sample.time_s, RecordEventKind::gate, kNoBody,
                 whose + std::string(gate_word(hand.gate)));
        }
    }
}

void RunRecorder::keep_body(double time_s, std::int32_t body, const BodyState& state) {
    BodyState& told = bodies_[static_cast<std::size_t>(body)];
    if (body < n_bodies_ && !is_same(told, state)) {
        told = state;
        write(RecordBody{time_s, body, state});
    }
}

void RunRecorder::keep_bodies(const SessionInput& input) {
    if (input.world != nullptr) {
        keep_effort(input.clock_s, input.world->effort);
        for (std::int32_t i = 0; i < input.world->n_bodies; ++i) {
            keep_body(input.clock_s, i, input.world->bodies[static_cast<std::size_t>(i)]);
        }
    }
    if (input.kite != nullptr && n_bodies_ > 0) {
        // It stands behind the lesson's bodies.
        keep_body(input.clock_s, n_bodies_ - 1,
                  {input.kite->report.pose_W, input.kite->report.velocity_W, BodyWhere::placed});
    }
}

void RunRecorder::keep_effort(double time_s, const WorldEffort& effort) {
    if (effort.n_unconverged != world_effort_.n_unconverged) {
        keep(time_s, RecordEventKind::cut, kNoBody,
             std::to_string(effort.n_unconverged - world_effort_.n_unconverged) + " " +
                 kUnconvergedWords);
    }
    world_effort_ = effort;
}

// A tool that must end its step in time says so when it leaves something out.
void RunRecorder::keep_effort(double time_s, const ToolEffort& effort) {
    if (effort.n_cut != effort_.n_cut) {
        keep(time_s, RecordEventKind::cut, kNoBody,
             std::to_string(effort.n_cut - effort_.n_cut) + " steps ended before their solver did");
    }
    for (std::size_t i = 0; i < kToolLacks; ++i) {
        if (effort.n_lacking[i] != effort_.n_lacking[i]) {
            keep(time_s, RecordEventKind::cut, kNoBody,
                 std::to_string(effort.n_lacking[i] - effort_.n_lacking[i]) + " steps " +
                     kToolLackWords[i]);
        }
    }
    if (effort.n_inexact != effort_.n_inexact) {
        keep(time_s, RecordEventKind::cut, kNoBody,
             std::to_string(effort.n_inexact - effort_.n_inexact) +
                 " steps left out points that may hold up to " + exact_text(effort.most_error_N) +
                 " N so far");
    }
    effort_ = effort;
}

void RunRecorder::keep_lateness(double time_s) {
    if (lateness_ == nullptr) {
        return;
    }
    if (const std::uint64_t n_late = lateness_->n_late(); n_late != n_late_) {
        keep(time_s, RecordEventKind::cut, kNoBody,
             std::to_string(n_late - n_late_) +
                 " steps gave less force, for contact was found too late: up to " +
                 exact_text(lateness_->age().max_s()) + " s so far");
        n_late_ = n_late;
    }
}

void RunRecorder::keep_frame(const SessionInput& input) {
    drain();
    keep_bodies(input);
    for (const WorldEvent& event : input.world_events) {
        keep(event.time_s, record_kind(event.kind), event.body);
    }
    if (input.hand.touched_body != touched_) {
        touched_ = input.hand.touched_body;
        if (touched_ != kNoBody) {
            keep(input.clock_s, RecordEventKind::touched, touched_);
        }
    }
    keep_effort(input.clock_s, input.hand.tool);
    keep_lateness(input.clock_s);
    for (const std::string& key : input.keys) {
        keep(input.clock_s, RecordEventKind::pressed, kNoBody, key);
    }
    if (input.wheel != 0.0) {
        keep(input.clock_s, RecordEventKind::wheel, kNoBody, exact_text(input.wheel));
    }
    if (input.heard) {
        keep(input.clock_s, RecordEventKind::answered, kNoBody, *input.heard);
    }
}

void RunRecorder::keep_output(double time_s, const SessionOutput& output,
                              const SessionResult& result) {
    for (const WorldCommand& command : output.world) {
        keep(time_s, record_kind(command.kind), command.body);
    }
    for (std::size_t i = 0; i < forces_.size() && i < fields_.size(); ++i) {
        const FieldCommand& field = output.force.fields[i];
        if (field.on != fields_[i].on || field.strength != fields_[i].strength) {
            keep(time_s, RecordEventKind::switched, kNoBody,
                 forces_[i] + (field.on ? " on " : " off ") + exact_text(field.strength));
        }
        fields_[i] = field;
    }
    for (const std::string& line : output.said) {
        keep(time_s, RecordEventKind::said, kNoBody, line);
    }
    for (const std::string& note : output.notes) {
        keep(time_s, RecordEventKind::note, kNoBody, note);
    }
    if (result.finished && !finished_) {
        finished_ = true;
        keep(time_s, RecordEventKind::finished, kNoBody,
             "score " + std::to_string(result.score) + ", " + std::to_string(result.stars) +
                 " of 3 stars");
    }
}

void RunRecorder::keep_failure(double time_s, const std::string& sentence) {
    keep(time_s, RecordEventKind::failed, kNoBody, sentence);
}

Expected<void> RunRecorder::finish() {
    drain();
    if (writer_) {
        note(writer_->finish());
    }
    return trouble_;
}

}  // namespace fulcrum::runtime
