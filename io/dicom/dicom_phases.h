#pragma once

#include <string>
#include <vector>

#include "io/dicom/dicom_header.h"

namespace isostack {

/// Several pictures of the same places: times of a heart beat, contrast phases, echoes.
struct DicomPhases {
  int count = 1;               ///< most pictures at one place
  std::size_t places = 0;      ///< different places
  std::size_t incomplete = 0;  ///< places with fewer than `count` pictures
  std::string ordered_by;      ///< "TriggerTime", ...; empty when every place has one picture
  std::vector<int> phase_of;   ///< for each picture, from 1
};

/// Numbers the pictures of each place by the first of TemporalPosition, TriggerTime, AcquisitionTime,
/// EchoTime and InstanceNumber that tells all of them apart, else by the order they come in. TemporalPosition
/// means the same phase everywhere; with the others the earliest at a place is its first phase.
/// `place_of` gives for each picture its place, from 0.
DicomPhases number_phases(const std::vector<DicomHeader>& pictures, const std::vector<std::size_t>& place_of);

}  // namespace isostack
