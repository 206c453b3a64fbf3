// rival_gdcm_read DIR: reads the bytes of every file in DIR one after the other, then decodes them with GDCM's image
// reader; least of five. The rival of read_series; links nothing of isostack.
#include <gdcmDirectory.h>
#include <gdcmImageReader.h>
#include <gdcmTrace.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

void read_bytes(const std::string& path, std::vector<char>& buffer) {
  std::ifstream stream(path, std::ios::binary);
  while (stream.read(buffer.data(), static_cast<std::streamsize>(buffer.size()))) continue;
}

bool decode(const std::string& path) {
  gdcm::ImageReader reader;
  reader.SetFileName(path.c_str());
  if (!reader.Read()) return false;
  std::vector<char> pixels(reader.GetImage().GetBufferLength());
  return reader.GetImage().GetBuffer(pixels.data());
}

}  // namespace

int main(int argc, char** argv) {
  gdcm::Trace::WarningOff();
  gdcm::Directory directory;
  directory.Load(argc > 1 ? argv[1] : ".");
  std::vector<char> buffer(1 << 20);
  double least_reading_s = 1e9, least_decoding_s = 1e9;
  std::size_t decoded = 0;
  for (int run = 0; run < 5; ++run) {
    auto start = Clock::now();
    for (const std::string& path : directory.GetFilenames()) read_bytes(path, buffer);
    least_reading_s = std::min(least_reading_s, seconds_since(start));
    start = Clock::now();
    decoded = 0;
    for (const std::string& path : directory.GetFilenames()) decoded += decode(path) ? 1 : 0;
    least_decoding_s = std::min(least_decoding_s, seconds_since(start));
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("seconds %.3f\npeak_gb %.2f\nremark %zu slices, least of 5 runs: bytes %.3f s, GDCM %.3f s\n",
              least_reading_s + least_decoding_s, static_cast<double>(usage.ru_maxrss) / 1e6, decoded, least_reading_s,
              least_decoding_s);
}
