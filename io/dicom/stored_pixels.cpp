#include "io/dicom/stored_pixels.h"

#include <cstdint>
#include <cstring>
#include <type_traits>

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
    return static_cast<double>(static_cast<Signed>(bits ^ sign_) - static_cast<Signed>(sign_));
  }

 private:
  /// Wide enough, and no wider: compilers turn only 32 bits into doubles several at a time.
  using Signed = std::conditional_t<sizeof(Word) < 4, std::int32_t, std::int64_t>;

  int down_;
  std::uint32_t mask_, sign_;
};

template <class Word>
void rescale(const char* stored, const DicomHeader& header, std::size_t count, float* pixels) {
  const StoredBits<Word> value_of(header);
  const double slope = header.slope, intercept = header.intercept;
  for (std::size_t i = 0; i < count; ++i) {
    Word word;
    std::memcpy(&word, stored + i * sizeof(Word), sizeof(Word));
    pixels[i] = static_cast<float>(value_of(word) * slope + intercept);
  }
}

}  // namespace

void rescale_stored(const char* stored, const DicomHeader& header, std::size_t count, float* pixels) {
  if (header.bits_allocated == 8) return rescale<std::uint8_t>(stored, header, count, pixels);
  if (header.bits_allocated == 16) return rescale<std::uint16_t>(stored, header, count, pixels);
  return rescale<std::uint32_t>(stored, header, count, pixels);
}

}  // namespace isostack
