#include "io/dicom/cielab.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace isostack {

namespace {

/// IEC 61966-2-1: linear sRGB to CIE XYZ.
Eigen::Matrix3d xyz_from_rgb() {
  Eigen::Matrix3d m;
  m << 0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339, 0.1191920, 0.9503041;
  return m;
}

const Eigen::Vector3d white_d65(0.950456, 1, 1.088754);
constexpr double knee = 6.0 / 29;  // CIE 15, where the cube root becomes a line

double compressed(double t) { return t > knee * knee * knee ? std::cbrt(t) : t / (3 * knee * knee) + 4.0 / 29; }
double expanded(double t) { return t > knee ? t * t * t : 3 * knee * knee * (t - 4.0 / 29); }

double gamma_encoded(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}
double gamma_decoded(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

std::uint8_t as_byte(double linear) {
  return static_cast<std::uint8_t>(std::lround(255 * gamma_encoded(std::clamp(linear, 0.0, 1.0))));
}

std::uint16_t as_word(double value, double lowest, double highest) {
  return static_cast<std::uint16_t>(std::lround(65535 * std::clamp((value - lowest) / (highest - lowest), 0.0, 1.0)));
}

}  // namespace

Color color_from_lab(const DicomLab& lab) {
  const double l = lab[0] * 100.0 / 65535, a = lab[1] * 255.0 / 65535 - 128, b = lab[2] * 255.0 / 65535 - 128;
  const double y = (l + 16) / 116;
  const Eigen::Vector3d xyz =
      Eigen::Vector3d(expanded(y + a / 500), expanded(y), expanded(y - b / 200)).cwiseProduct(white_d65);
  const Eigen::Vector3d rgb = xyz_from_rgb().inverse() * xyz;
  return {as_byte(rgb[0]), as_byte(rgb[1]), as_byte(rgb[2])};
}

DicomLab lab_from_color(const Color& color) {
  const Eigen::Vector3d rgb(gamma_decoded(color.red / 255.0), gamma_decoded(color.green / 255.0),
                            gamma_decoded(color.blue / 255.0));
  const Eigen::Vector3d t = (xyz_from_rgb() * rgb).cwiseQuotient(white_d65).unaryExpr(&compressed);
  return {as_word(116 * t[1] - 16, 0, 100), as_word(500 * (t[0] - t[1]), -128, 127),
          as_word(200 * (t[1] - t[2]), -128, 127)};
}

}  // namespace isostack
