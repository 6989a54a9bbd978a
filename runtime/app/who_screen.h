// "Who are you?" in a window, before the list of lessons, where a class was made (progress/class_list.h).
//
//   [class, where there are several] -> card -> secret picture -> the pupil
//                                       guest -----------------> nobody of the class
//   shown as names:                     card ------------------> the pupil
//
// Escape goes a step back. A wrong picture turns all of them face down, for longer each time (`wait_after_s`), going back does not make
// that shorter; nobody is let in by it.
#pragma once

#include "dialogue/catalogue.h"
#include "runtime/app/card_picker.h"
#include "runtime/progress/class_list.h"
#include "runtime/progress/store.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// The picture of a guest's card; no pupil's.
inline constexpr const char* kGuestPicture = "hand";

/// What is said above the secret pictures.
enum class SecretSaid : std::uint8_t { asked, wrong };

/// The pictures of each step; the last card of a class is a guest's, that of the secret pictures leads back. For tests, too.
[[nodiscard]] View classes_view(const std::vector<SchoolClass>& classes, const MenuChoice& choice,
                                const dialogue::Catalogue& catalogue);
[[nodiscard]] View pupils_view(const SchoolClass& one, const MenuChoice& choice,
                               const dialogue::Catalogue& catalogue);
[[nodiscard]] View secret_view(const Pupil& pupil, const MenuChoice& choice,
                               const dialogue::Catalogue& catalogue, SecretSaid said);
/// The same with its pictures face down.
[[nodiscard]] View turned_down(View view);

/// Whether the secret picture on this card is the pupil's; no card that is none of them is.
[[nodiscard]] bool is_secret_of(const Pupil& pupil, int card) noexcept;
/// How long nobody can choose after so many wrong pictures in a row: 1, 2, 4, then 8 s.
[[nodiscard]] double wait_after_s(int n_wrong) noexcept;

class WhoScreen {
  public:
    /// What is given outlives the screen. `only`: the class of this name alone; empty: each.
    WhoScreen(Desktop& desktop, const dialogue::Catalogue& catalogue, ProgressStore& store,
              std::string only);

    /// Looks which classes there are now; refuses a class to be alone that is not there. What cannot be read stays as it was.
    [[nodiscard]] Expected<void> read();
    /// Whether there is a class, so that somebody can be asked.
    [[nodiscard]] bool has_class() const { return !classes_.empty(); }
    /// Asks until it is known: the pupil's nickname, or none for a guest. Nothing when they left.
    [[nodiscard]] std::optional<std::string> ask();

  private:
    enum class Found : std::uint8_t { yes, back, closed };
    Found ask_class(const SchoolClass& one);
    Found ask_secret(const Pupil& pupil);

    Desktop& desktop_;
    const dialogue::Catalogue& catalogue_;
    ProgressStore& store_;
    std::string only_;
    std::vector<SchoolClass> classes_;
    CardPicker picker_;
    std::string found_;
    std::map<LearnerId, int> n_wrong_;  // in a row
};

}  // namespace fulcrum::runtime
