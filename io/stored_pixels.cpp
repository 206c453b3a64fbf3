#include "io/stored_pixels.h"

#include <cstdint>
#include <cstring>

namespace isostack {

namespace {

/// Bits outside of the stored ones once held overlays.
template <class Word>
class StoredBits {
 public:
  explicit StoredBits(const DicomHeader& header)
      : down_(header.high_bit + 1 - header.bits_stored),
        mask_(header.bits_stored == 32 ? 0xffffffffu : (1u << header.bits_stored) - 1),
        sign_(header.is_signed ? 1u << (header.bits_stored - 1) : 0) {}

  double operator()(Word word) const {
    const std::uint32_t bits = (static_cast<std::uint32_t>(word) >> down_) & mask_;
    return static_cast<double>(static_cast<std::int64_t>(bits ^ sign_) - static_cast<std::int64_t>(sign_));
  }

 private:
  int down_;
  std::uint32_t mask_, sign_;
};

template <class Word>
void rescale(const char* stored, const DicomHeader& header, float* pixels) {
  const StoredBits<Word> value_of(header);
  const std::size_t count = static_cast<std::size_t>(header.rows) * static_cast<std::size_t>(header.columns);
  for (std::size_t i = 0; i < count; ++i) {
    Word word;
    std::memcpy(&word, stored + i * sizeof(Word), sizeof(Word));
    pixels[i] = static_cast<float>(value_of(word) * header.slope + header.intercept);
  }
}

}  // namespace

void rescale_stored(const char* stored, const DicomHeader& header, float* pixels) {
  if (header.bits_allocated == 8) return rescale<std::uint8_t>(stored, header, pixels);
  if (header.bits_allocated == 16) return rescale<std::uint16_t>(stored, header, pixels);
  return rescale<std::uint32_t>(stored, header, pixels);
}

}  // namespace isostack
