#pragma once

#include <sstream>
#include <string>

namespace isostack {

/// A number for a message, rounded to so many significant digits.
inline std::string number_text(double value, int digits = 6) {
  std::ostringstream out;
  out.precision(digits);
  out << value;
  return out.str();
}

}  // namespace isostack
