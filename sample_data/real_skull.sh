#!/usr/bin/env bash
# real_skull.sh OUT_DIR: puts a CT of a human head, from Debian's package invesalius-examples, into OUT_DIR as
# cranium.mhd + cranium.raw, ready for: isostack reconstruct OUT_DIR/cranium.mhd --level -300 -o head.stl
# (-300 HU: the skin; 300 HU: bone).
set -euo pipefail

if [[ $# -ne 1 || $1 == -* ]]; then
  echo "usage: real_skull.sh OUT_DIR" >&2
  exit 2
fi
out_dir=$1
archive=/usr/share/doc/invesalius-examples/examples/Cranium.inv3

if [[ ! -e $archive ]]; then
  as_root=()
  [[ $(id -u) -eq 0 ]] || as_root=(sudo)
  "${as_root[@]}" apt-get update >&2
  "${as_root[@]}" apt-get install --yes --no-install-recommends invesalius-examples >&2
fi
if [[ ! -e $archive ]]; then
  echo "$archive: not there although the package is installed; dpkg may be set to leave out /usr/share/doc" \
    "(see /etc/dpkg/dpkg.cfg.d); allow it and install invesalius-examples again." >&2
  exit 3
fi

mkdir -p "$out_dir"
unpacked=$(mktemp -d "$out_dir/.unpacked.XXXXXX")
trap 'rm -rf "$unpacked"' EXIT
tar --extract --no-same-owner --file "$archive" --directory "$unpacked" --strip-components 1

# The project file names the matrix, its shape (slices, rows, columns), type and spacing (column, row, slice; mm).
# Values are Hounsfield units already. Slices run from the teeth up to the crown, rows from the back of the head to the
# face. Columns are taken to run from the patient's right to the left, as in any axial CT (InVesalius turned the rows
# about): a head is too symmetric to show it, so left and right are an assumption.
# Hence, in DICOM patient space (LPS): columns +x, rows -y, slices +z.
python3 - "$unpacked" "$out_dir" <<'PYTHON'
import os
import plistlib
import sys

unpacked, out_dir = sys.argv[1:]
with open(os.path.join(unpacked, "main.plist"), "rb") as file:
    project = plistlib.load(file)
matrix = project["matrix"]
slices, rows, columns = matrix["shape"]
dx, dy, dz = project["spacing"]
if matrix["dtype"] != "int16" or project["modality"] != "CT":
    sys.exit("Cranium.inv3: not a CT of 16-bit numbers; use the package's version 3.1.")
raw = os.path.join(unpacked, matrix["filename"])
if os.path.getsize(raw) != 2 * slices * rows * columns:
    sys.exit("Cranium.inv3: its matrix has an unexpected size; install invesalius-examples again.")
header = f"""ObjectType = Image
NDims = 3
BinaryData = True
BinaryDataByteOrderMSB = False
CompressedData = False
TransformMatrix = 1 0 0 0 -1 0 0 0 1
Offset = {-(columns - 1) / 2 * dx:.6f} {(rows - 1) / 2 * dy:.6f} 0
CenterOfRotation = 0 0 0
ElementSpacing = {dx:.6f} {dy:.6f} {dz:.6f}
DimSize = {columns} {rows} {slices}
ElementType = MET_SHORT
ElementDataFile = cranium.raw
"""
os.chmod(raw, 0o644)
os.replace(raw, os.path.join(out_dir, "cranium.raw"))
partial = os.path.join(unpacked, "cranium.mhd")
with open(partial, "w", encoding="ascii") as file:
    file.write(header)
os.replace(partial, os.path.join(out_dir, "cranium.mhd"))
PYTHON
echo "wrote $out_dir/cranium.mhd and cranium.raw"
