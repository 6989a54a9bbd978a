// Amounts as people read them.
//
// Thread: any.
#pragma once

#include <cstddef>
#include <string>

namespace fulcrum::runtime {

/// A length as people read it: "0.05 mm", "12.5 mm", "120 mm", "1.5 m"; three digits.
[[nodiscard]] std::string metres_text(double metres);

/// Bytes as people read them: "96 B", "1.5 kB", "2.0 MB".
[[nodiscard]] std::string bytes_text(std::size_t bytes);

/// A number with so many decimals.
[[nodiscard]] std::string number_text(double value, int decimals);
/// Newtons as a child reads them: one decimal.
[[nodiscard]] std::string newtons_text(double newtons);

}  // namespace fulcrum::runtime
