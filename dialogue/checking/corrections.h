// What is put right in a text: carried out, and joined with what is put right in the outcome.
//
// Thread: pure.  Cost: linear in the text and in what is put right.
#pragma once

#include "dialogue/checking/proposal.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::dialogue {

/// Bytes [begin, end) of `text` with the proposals in it carried out, each between two `mark`s; blanks stand outside the marks. None of
/// `proposals` lies over another.
[[nodiscard]] std::string carried_out(std::string_view text, std::size_t begin, std::size_t end,
                                      std::vector<Proposal> proposals, std::string_view mark = {});

/// `first` puts `text` right, and `then`, told in bytes of the outcome, what was still wrong there: both as proposals for `text`, in its
/// order. Where `then` changes what `first` wrote they are one, of the first one's kind, unless nothing belongs there at all; none is left where nothing changes.
[[nodiscard]] std::vector<Proposal> joined(std::string_view text, std::vector<Proposal> first,
                                           std::vector<Proposal> then);

}  // namespace fulcrum::dialogue
