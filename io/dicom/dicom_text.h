#pragma once

#include <string>

namespace isostack {

/// DICOM text as UTF-8. `character_set` is SpecificCharacterSet (PS3.3, C.12.1.1.2); bytes that it does not explain
/// become '?'. Control characters are left out.
std::string utf8_from_dicom(const std::string& text, const std::string& character_set);

/// UTF-8 as it may stand in a DICOM short text of character set ISO_IR 192: no backslashes or control characters, at
/// most `most_characters`.
std::string dicom_from_utf8(const std::string& text, std::size_t most_characters);

bool is_ascii(const std::string& text);

}  // namespace isostack
