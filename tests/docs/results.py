"""Forms of every command whose results are looked at. A few lines each; what shows a key of the result that no other does is here."""

SHARED = "../shared/data"

BALL = {"format": "isostack-solid", "version": 1, "solid": {"superellipsoid": {"radii_mm": [20, 20, 20]}}}

PREPARE = """
segment sample/series --level 25 --curvature 1 --largest -o organ.vtp
segment sample/series --level 25 --curvature 1 --largest -o organ.json --save-recipe organ.recipe.json
convert shapes/sphere.ply --voxel 3 -o sphere.nii.gz
"""

INFO = """
info sample/series sample/planes
info sample/truth.stl organ.json organ.dcm shapes/x.png labels.seg.nrrd seg.dcm
info sphere.nii.gz keys/head_scan.mha labels.mha
"""

SEGMENT = """
segment sample/planes --level 25 --curvature 1 -o planes.vtp
segment sample/series --level 25 -o organ.dcm
segment keys/head_scan.mha --level 226 --every 1 -o labels.mha
segment keys/head_scan.mha --level 226 -o labels.seg.nrrd
segment keys/head_scan.mha --level 226 --as seg -o seg.dcm
segment keys/head_scan.mha --recipe skin --distance skin.mha -o skin.json
"""

RECONSTRUCT = """
reconstruct organ.json --max-constraints 500 --resolution 4 --simplify 0.5 -o coarse.stl
reconstruct organ.json --max-constraints 500 --resolution 4 --solver dense --thin 1 -o coarse.ply -o coarse.nii.gz --grid keys/head_scan.mha
reconstruct planes.vtp --max-constraints 500 --resolution 4 --align --align-rotation --aligned aligned.vtp -o aligned.stl
reconstruct organ.json --max-constraints 600 --resolution 6 --kernel auto -o auto.stl
reconstruct organ.json --max-constraints 500 --dry-run
reconstruct sample/series --level 25 --preset turk-obrien --max-constraints 800 --resolution 4 --accept-residual -o paper.stl
"""

MEASURE = """
measure sample/truth.stl
measure coarse.stl --against sample/truth.stl --samples 1000
measure coarse.nii.gz --against coarse.nii.gz --samples 1000
measure ball.json
measure organ.json --leave-out 3,6 --max-constraints 500 --plot leave_out.svg
"""

CONVERT = """
convert organ.json -o organ.csl
convert coarse.stl -o coarse.glb
convert coarse.stl --edge-length 5 -o even.ply
convert labels.seg.nrrd -o labels.nii.gz
convert keys/head_scan.mha -o head.nrrd
convert ball.json --voxel 4 -o head_distances.mha
convert keys/head.ply --voxel 8 -o mesh_distances.mha
convert head_distances.mha -o head_surface.stl
"""

MORPH = """
morph shapes/x.png shapes/o.png --frames 3 --max-constraints 600 -o x_to_o.json
morph shapes/x.png shapes/o.png --frames 3 --method signed-distance -o between --format json
morph shapes/x.png shapes/o.png --frames 3 --method level-set -o flowing.json
morph keys/discs.json keys/cross.json --frames 3 --method blend -o blended.json
morph shapes/one.json shapes/two.json --frames 3 --method subdivision -o subdivided.json
morph shapes/discs.png shapes/o.png --frames 3 --method level-set --missing-parts leave -o parts.json
morph shapes/sphere.ply shapes/torus.ply --frames 2 --max-constraints 600 --resolution 6 --plot over_t.svg -o bodies.stl
"""

VIEW = """
view coarse.stl organ.vtp --size 320x240 --screenshot view.png
view sample/planes planes.vtp --contradiction --size 320x240 --screenshot contradiction.png
view coarse.stl --html page.html
"""

RUN = """
run pipeline.json --force
run pipeline.json
run pipeline.json --input series=sample/planes --output-dir elsewhere --dry-run
run organ.recipe.json
"""

BATCH = """
["info", "organ.json"]
["measure", "nowhere.stl", "--json"]
"""

# of real data, where it is there
SHARED_FORMS = """
info {shared}/bad_dicom {shared}/head_ct_tilt {shared}/cardiac_mr {shared}/rtstruct {shared}/dicom_seg
info {shared}/rtstruct/breast.dcm {shared}/meshes/kitten.obj
"""

WINDOW = "view coarse.stl organ.vtp --size 500x400"

# exit code, kind, line
FAILURES = [
    (2, "UsageError", "segment sample/series"),
    (2, "UsageError", "fly"),
    (2, "UsageError", "measure sample/truth.stl --samples many"),
    (3, "InputError", "info nowhere"),
    (3, "InputError", "segment sample/series --level 25 --propagate 1 -o a.xyz"),
    (3, "GeometryError", "segment sample/series --level 25 --distance d.mha -o a.vtp"),
    (4, "SolveError", "reconstruct organ.json --max-constraints 3000 --solver dense --memory 0.001 -o a.stl"),
]


def lines(text):
    return [line for line in text.splitlines() if line]

# schema, place in its documents, value that must not pass
WRONG_VALUES = [
    ("info", ("inputs", 0, "series", 0, "tilt_deg"), 120),
    ("info", ("inputs", 0, "series", 0, "extent_mm"), [1, 2]),
    ("info", ("inputs", 0, "series", 0, "slices"), -1),
    ("info", ("inputs", 0, "series", 0, "orientation"), "up"),
    ("info", ("inputs", 0, "series"), []),
    ("segment", ("organs", 0, "area_mm2", 0), -1),
    ("segment", ("organs", 0, "slices"), 2.5),
    ("segment", ("isostack",), "zero"),
    ("reconstruct", ("surfaces", 0, "sections", "dice"), 1.01),
    ("reconstruct", ("surfaces", 0, "largest_residual_mm"), -0.1),
    ("reconstruct", ("surfaces", 0, "seconds", "solve"), -1),
    ("reconstruct", ("surfaces", 0, "resolution_mm"), 0),
    ("reconstruct", ("surfaces", 0, "solver"), "abacus"),
    ("reconstruct", ("surfaces",), []),
    ("reconstruct", ("alignments", 0, "slices", 0, "rotation_deg"), 200),
    ("reconstruct", ("alignments", 0, "slices", 0, "shift_mm"), [1, 2, 3]),
    ("reconstruct", ("kernels", 0, "kernel"), "r"),
    ("reconstruct", ("predictions", 0, "solver"), "slow"),
    ("reconstruct", ("predicted_process_bytes",), -1),
    ("batch", ("peak_bytes",), -1),
    ("batch", ("arguments",), []),
    ("measure", ("shape", "area_mm2"), -1),
    ("measure", ("shape", "genus"), -1),
    ("measure", ("comparison", "dice"), 1.5),
    ("measure", ("leave_out", 0, "every"), 1),
    ("measure", ("leave_out", 0, "methods", 0, "method"), "guess"),
    ("convert", ("kind",), "sound"),
    ("convert", ("voxels",), [1, 2]),
    ("convert", ("retriangulation", "smallest_angle_deg"), 61),
    ("morph", ("method",), "magic"),
    ("morph", ("frames", 0, "t"), 1.5),
    ("morph", ("shapes", 0, "dimension"), 5),
    ("morph", ("topology_changes",), [[0.1]]),
    ("morph", ("courses", 0, "shared_fraction"), [0.5, 2]),
    ("view", ("window", "opened_ms"), -1),
    ("view", ("contradiction", "places", 0, "middle_mm"), [1, 2]),
    ("run", ("steps", 0, "state"), "slept"),
    ("run", ("steps", 0, "seconds"), -1),
    ("error", ("error", "exit_code"), 1),
    ("error", ("error", "kind"), "Surprise"),
    ("error", ("error", "message"), ""),
    ("pipeline", ("version",), 2),
    ("pipeline", ("steps", 0, "command"), "fly"),
    ("pipeline", ("steps", 0, "options", "level"), {"at": 25}),
    ("pipeline", ("inputs", "series", "sha256"), "short"),
    ("contours", ("organs", 0, "slices", 0, "pose", "x_axis"), [1, 0]),
    ("contours", ("version",), 2),
    ("view-session", ("state", "plane"), -1),
    ("view-session", ("state", "seeds", 0, "position_mm"), [1, 2]),
]
