#pragma once

#include <cstddef>

namespace isostack {

/// Which picture of a sequence is shown, and whether they run by.
class Playback {
 public:
  explicit Playback(std::size_t count = 0, double pictures_per_second = 12)
      : count_(count), rate_(pictures_per_second) {}

  std::size_t count() const { return count_; }
  std::size_t position() const { return position_; }
  bool is_playing() const { return is_playing_; }

  /// Stops at the first or last picture.
  void show(std::ptrdiff_t position) {
    const auto last = static_cast<std::ptrdiff_t>(count_) - 1;
    position_ = position <= 0 || last < 0 ? 0 : static_cast<std::size_t>(position < last ? position : last);
    seconds_ = 0;
  }
  void step(std::ptrdiff_t by) { show(static_cast<std::ptrdiff_t>(position_) + by); }
  void play_or_pause() { is_playing_ = !is_playing_ && count_ > 1; }
  void pause() { is_playing_ = false; }

  /// Lets time pass; after the last picture comes the first. True when the picture has changed.
  bool advance(double seconds) {
    if (!is_playing_) return false;
    seconds_ += seconds;
    const auto pictures = static_cast<std::size_t>(seconds_ * rate_);
    seconds_ -= static_cast<double>(pictures) / rate_;
    position_ = (position_ + pictures) % count_;
    return pictures % count_ != 0;
  }

 private:
  std::size_t count_;
  double rate_;
  std::size_t position_ = 0;
  double seconds_ = 0;  ///< since this picture was due
  bool is_playing_ = false;
};

}  // namespace isostack
