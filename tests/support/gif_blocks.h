// What a GIF file holds, by its blocks: no pixel is decoded.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace isostack::testing_support {

struct GifBlocks {
  int width = 0, height = 0;
  int pictures = 0;
  std::vector<int> delays_hundredths;  ///< one per picture
  int loops = -1;                      ///< 0: for ever; -1: not said
};

/// Throws std::out_of_range or std::runtime_error when the file is no whole GIF.
inline GifBlocks gif_blocks(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(file)), {});
  const auto byte = [&](std::size_t at) { return static_cast<int>(static_cast<unsigned char>(text.at(at))); };
  const auto word = [&](std::size_t at) { return byte(at) + 256 * byte(at + 1); };
  const auto table_bytes = [](int flags) { return (flags & 0x80) ? std::size_t{6} << (flags & 7) : std::size_t{0}; };
  const auto after_sub_blocks = [&](std::size_t at) {
    while (byte(at) != 0) at += static_cast<std::size_t>(byte(at)) + 1;
    return at + 1;
  };
  if (!text.starts_with("GIF89a")) throw std::runtime_error("not a GIF");
  GifBlocks blocks{.width = word(6), .height = word(8), .delays_hundredths = {}};
  std::size_t at = 13 + table_bytes(byte(10));
  while (byte(at) != 0x3b) {
    if (byte(at) == 0x21) {
      if (byte(at + 1) == 0xf9) blocks.delays_hundredths.push_back(word(at + 4));
      if (byte(at + 1) == 0xff && text.substr(at + 3, 11) == "NETSCAPE2.0") blocks.loops = word(at + 16);
      at = after_sub_blocks(at + 2);
    } else if (byte(at) == 0x2c) {
      ++blocks.pictures;
      at = after_sub_blocks(at + 11 + table_bytes(byte(at + 9)));
    } else {
      throw std::runtime_error("a block of unknown kind");
    }
  }
  return blocks;
}

}  // namespace isostack::testing_support
