// One connection to the Haply Inverse Service, which is one session: gone with the connection, its configuration too.
//
// Thread: its owner's. Cost: opening takes four questions, each with its deadline; then a message and its answer.
// Source: docs.haply.co/inverseSDK/service: api/http ("Version"), api/settings ("devices/force_scale"), realtime/websocket-protocol.
#pragma once

#include "runtime/arms/haply/haply_command.h"
#include "runtime/arms/haply/haply_message.h"
#include "runtime/arms/haply/message_log.h"
#include "runtime/arms/websocket/web_socket.h"

namespace fulcrum::runtime {

/// One setting alone, as from 3.5 on, and all of them.
inline constexpr std::string_view kHaplyScalePath = "/settings/devices/force_scale";
inline constexpr std::string_view kHaplySettingsPath = "/settings";

class HaplySession {
  public:
    enum class Heard : unsigned char { state, nothing, nonsense, gone };

    /// Refuses where nobody answers within `patience_s` for each question, and what haply_judge.h refuses. `log` outlives it.
    [[nodiscard]] static Expected<std::unique_ptr<HaplySession>> open(std::uint16_t port,
                                                                      const std::string& device_id,
                                                                      double patience_s,
                                                                      MessageLog& log);

    /// False where it did not go by the deadline: then the line is of no more use.
    [[nodiscard]] bool send(const Vector3& force_A, ForceWord word, bool wants_all,
                            double deadline_s);
    /// The next answer, by the deadline.
    [[nodiscard]] Heard receive(HaplyMessage& message, double deadline_s);
    /// Why nothing of use came, a clause.
    [[nodiscard]] const std::string& why() const noexcept { return why_; }
    void close() noexcept { socket_->close(); }

    /// As the first message had it.
    [[nodiscard]] const HaplyArm& arm() const noexcept { return arm_; }
    [[nodiscard]] const std::string& version() const noexcept { return version_; }
    [[nodiscard]] ForceWord word() const noexcept { return word_; }
    /// What multiplies every force; nothing where the service does not tell.
    [[nodiscard]] std::optional<double> force_scale() const noexcept { return force_scale_; }
    /// Where it tells.
    [[nodiscard]] std::string_view scale_path() const noexcept { return scale_path_; }

  private:
    explicit HaplySession(MessageLog& log) : log_(log) {}
    [[nodiscard]] Expected<void> ask_version(std::uint16_t port, double patience_s);
    [[nodiscard]] Expected<void> ask_scale(std::uint16_t port, double patience_s);
    [[nodiscard]] Expected<void> meet(std::uint16_t port, const std::string& device_id,
                                      double patience_s);

    MessageLog& log_;
    std::unique_ptr<WebSocket> socket_;
    HaplyArm arm_{};
    std::string version_;
    ForceWord word_ = ForceWord::vector;
    std::optional<double> force_scale_;
    std::string_view scale_path_;
    std::string command_;  // reused
    std::string text_;     // likewise
    std::string why_;
};

}  // namespace fulcrum::runtime
