#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What `palpate-cli info` says of every scan and every broken file beside the checkout.

Usage: scans_test.py PALPATE_CLI SCANS

The table says what each must be, after what independent readers found. What stands in the folder
and not in the table fails, so that none is forgotten. Nothing may crash, take ten seconds, or take
more memory than the voxels that are really there need.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

MOST_S = 10.0
# libraries, and what a codec or a whole compressed file may need beside the voxels
MOST_MB, MOST_PER_VOXEL_BYTE = 250.0, 3.5

SOUND, COPIES, SIDELESS = "sound", "sound duplicate", "sound orientation-unknown"
TILTED = "correctable gantry-tilt"
SEVERAL = "several"  # that can be loaded, in one folder or in one file

# folder: what is in it by name, or what it is as a whole
TABLE = {
    "philips_head_phantom": {
        "bone_1mm": SOUND, "gantry_tilt_16.5deg": TILTED, "mixed_series_one_folder": SEVERAL},
    "visible_human_female_head": {"dicom_slab": SOUND, "vhf_head_512x512x234.nrrd": SOUND},
    "stanford_bunny": {
        "bunny_512x512x361_airflat.nrrd": SOUND, "bunny_exact_crop_200x200x80.nrrd": SOUND},
    "stanford_cthead": {"cthead_256x256x113_be.nrrd": SOUND},
    "volvis_classics": {"engine.nhdr": SIDELESS, "bonsai.nhdr": SIDELESS},
    "seg3d_tooth": {"tooth.nhdr": SIDELESS},
    "dicom_oddities": {
        "series_non_isotropic_slope": SOUND, "series_rgb": "refused not-scalar"},
    "dicom_oddities/series_failing": {
        "gantrytilting": TILTED, "slicecount": SOUND, "sliceincrement": "refused missing-slices",
        "sliceorientation": SEVERAL},  # two protocols of two slices
    "dicom_oddities/series_sagittal_mr": {
        "compressed_j2k": SOUND, "compressed_jpeg": SOUND, "compressed_jpegls": SOUND,
        "compressed_rle": SOUND, "uncompressed": SOUND},
    "dicom_oddities/multiframe": {
        "eCT_Supplemental.dcm": SOUND, "philips_enhanced_mr.dcm": SOUND,
        "siemens_xa_enhanced_mr.dcm": SOUND,
        # no position anywhere
        "emri_small.dcm": "refused bad-header", "emri_small_RLE.dcm": "refused bad-header",
        "emri_small_big_endian.dcm": "refused bad-header",
        "emri_small_jpeg_2k_lossless.dcm": "refused bad-header"},
    "dicom_oddities/fo_dicom": {
        "CR-MONO1-10-chest": "refused bad-header", "CT-MONO2-16-ankle": "refused bad-header",
        "D_CLUNIE_CT1_RLE_FRAGS.dcm": SOUND},
    "dicom_oddities/transfer_syntaxes": {
        # one slice in many encodings: the one that is named is taken
        "CTImage_BigEndianExplicitTransferSyntax_1.2.840.10008.1.2.2.dcm": COPIES,
        "CTImage_DeflatedExplicitVRLittleEndianTransferSyntax_1.2.840.10008.1.2.1.99.dcm": COPIES,
        "CTImage_JPEG2000LosslessOnlyTransferSyntax_1.2.840.10008.1.2.4.90.dcm": COPIES,
        "CTImage_JPEG2000TransferSyntax_1.2.840.10008.1.2.4.91.dcm": COPIES,
        "CTImage_JPEGLSLosslessTransferSyntax_1.2.840.10008.1.2.4.80.dcm": COPIES,
        "CTImage_JPEGLSLossyTransferSyntax_1.2.840.10008.1.2.4.81.dcm": COPIES,
        "CTImage_JPEGProcess14SV1TransferSyntax_1.2.840.10008.1.2.4.70.dcm": COPIES,
        "CTImage_JPEGProcess14TransferSyntax_1.2.840.10008.1.2.4.57.dcm": COPIES,
        "CTImage_JPEGProcess1TransferSyntax_1.2.840.10008.1.2.4.50.dcm": COPIES,
        "CTImage_JPEGProcess2_4TransferSyntax_1.2.840.10008.1.2.4.51.dcm": COPIES,
        "CTImage_LittleEndianExplicitTransferSyntax_1.2.840.10008.1.2.1.dcm": COPIES,
        "CTImage_LittleEndianImplicitTransferSyntax_1.2.840.10008.1.2.dcm": COPIES,
        "CTImage_RLELosslessTransferSyntax_1.2.840.10008.1.2.5.dcm": COPIES,
        # retired, and decoded by nobody
        "CTImage_JPEGProcess10_12TransferSyntax_1.2.840.10008.1.2.4.55.dcm":
            "refused unsupported-syntax",
        "CTImage_JPEGProcess6_8TransferSyntax_1.2.840.10008.1.2.4.53.dcm":
            "refused unsupported-syntax",
        # an enhanced object of two frames
        "CT0012.fragmented_no_bot_jpeg_baseline.51.dcm": SOUND,
        "no-pixel-data.dcm": "refused no-pixels", "no-pixel-spacing.dcm": "refused not-scalar"},
    "dicom_oddities/pydicom": {
        "693_J2KI.dcm": SOUND, "CT_small.dcm": SOUND,
        "MR_small.dcm": COPIES, "MR_small_RLE.dcm": COPIES, "MR_small_bigendian.dcm": COPIES,
        "MR_small_expb.dcm": COPIES, "MR_small_implicit.dcm": COPIES,
        "MR_small_jp2klossless.dcm": COPIES, "MR_small_jpeg_ls_lossless.dcm": COPIES,
        "MR_small_padded.dcm": COPIES,
        "MR_truncated.dcm": "refused truncated",
        "ExplVR_BigEnd.dcm": "refused not-scalar", "SC_rgb_rle_16bit_2frame.dcm":
            "refused not-scalar",
        "JPEG-lossy.dcm": "refused bad-header", "JPEG2000.dcm": "refused bad-header",
        "JPEGLSNearLossless_16.dcm": "refused bad-header", "JPGExtended.dcm": "refused bad-header",
        "badVR.dcm": "refused bad-header", "image_dfl.dcm": "refused bad-header",
        "liver_1frame.dcm": "refused no-pixels", "no_meta.dcm": "refused unreadable",
        "no_meta_group_length.dcm": "refused bad-header", "rtdose.dcm": "refused bad-header",
        "rtstruct.dcm": "refused no-pixels"},
    "nrrd_oddities/fnndsc": {
        "adi_slice.nrrd": SOUND, "avf_float_32.nrrd": SOUND, "fetal_template_T2.nrrd": SOUND},
    "nrrd_oddities/pynrrd": {
        "BallBinary30x30x30.nhdr": SOUND, "BallBinary30x30x30.nrrd": SOUND,
        "BallBinary30x30x30_byteskip_minus_one.nhdr": SOUND,
        "BallBinary30x30x30_byteskip_minus_one_nifti.nhdr": SOUND,
        "BallBinary30x30x30_bz2.nrrd": SOUND, "BallBinary30x30x30_gz.nrrd": SOUND,
        "BallBinary30x30x30_gz_byteskip_minus_one.nrrd": SOUND,
        "BallBinary30x30x30_gz_lineskip.nrrd": SOUND,
        "BallBinary30x30x30_byteskip_minus_five.nhdr": "refused bad-header",
        "BallBinary30x30x30_nifti.nhdr": "refused bad-header",
        "test1d_ascii.nrrd": "refused not-scalar", "test2d_ascii.nrrd": "refused not-scalar",
        "test_customFields.nrrd": "refused not-scalar",
        # four axes, the last of one entry
        "test_simple4d_raw.nrrd": SOUND},
    "nrrd_oddities/malformed": {
        "bad_magic.nrrd": "refused bad-header", "empty.nrrd": "refused bad-header",
        "header_only.nrrd": "refused truncated", "huge_sizes.nrrd": "refused truncated",
        "missing_data_file.nhdr": "refused truncated", "missing_sizes.nrrd": "refused bad-header",
        "short_raw.nrrd": "refused truncated", "truncated_gzip.nrrd": "refused truncated",
        "unknown_encoding.nrrd": "refused unsupported-syntax"},
    "nrrd_oddities/derived_from_tooth": {
        "2d_slice.nrrd": "refused not-scalar", "4d_list_last_axis.nrrd": SEVERAL,
        "4d_vector_first_axis.nrrd": "refused not-scalar",
        "nan_spacing_axis.nrrd": "refused bad-header", "sheared_gantry_like.nrrd":
            "refused sheared",
        "float_nan_inf.nrrd": SOUND, "left_handed.nrrd": SOUND, "oblique_orthonormal.nrrd": SOUND,
        "space_las_flipped_axes.nrrd": SOUND, "space_lps.nrrd": SOUND, "space_ras.nrrd": SOUND,
        "anisotropic_0.3x0.3x5.nrrd": SIDELESS, "ascii.nrrd": SIDELESS, "bzip2.nrrd": SIDELESS,
        "crlf_header.nrrd": SIDELESS, "detached_gzip.nhdr": SIDELESS, "double.nrrd": SIDELESS,
        "hex_be.nrrd": SIDELESS, "int32.nrrd": SIDELESS, "int8_signed.nrrd": SIDELESS,
        "keyvalue_and_minmax.nrrd": SIDELESS, "multifile_list.nhdr": SIDELESS,
        "multifile_pattern.nhdr": SIDELESS, "no_spacing.nrrd": SIDELESS,
        "old_magic_NRRD0001.nrrd": SIDELESS, "one_slice_3d.nrrd": SIDELESS,
        "raw_be.nrrd": SIDELESS, "raw_le.nrrd": SIDELESS, "skips.nhdr": SIDELESS,
        "uint32.nrrd": SIDELESS},
}
# voxels that a header elsewhere names, notes, tools
NOT_ASKED = (".raw", ".gz", ".dat", ".txt", ".par", ".md")
NOT_ASKED_NAMES = ("SHA256SUMS", "slices", "tools")


def info(cli, path, *options):
    """What it says, its exit code, seconds, megabytes, and what it prints besides."""
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as besides:
        began = time.monotonic()
        child = subprocess.Popen([cli, "info", str(path), "--json", *options], stdout=out,
                                 stderr=besides)
        _, status, used = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        seconds = time.monotonic() - began
        out.seek(0)
        besides.seek(0)
        said = json.loads(out.read())
        noise = [line for line in besides.read().decode(errors="replace").splitlines()
                 if line != said.get("message") and line != said.get("error", {}).get("message")]
        return said, child.returncode, seconds, used.ru_maxrss / 1024.0, noise


def verdict_of(said):
    if "verdict" not in said:
        loadable = [s for s in said.get("series", []) if s["verdict"] == "sound"]
        return SEVERAL if len(loadable) > 1 else "none"
    return " ".join([said["verdict"], *said["reasons"]])


def voxel_mb(said):
    if "dims" not in said:
        return 0.0
    i, j, k = said["dims"]
    size = {"8": 1, "16": 2, "32": 4}[said["scalar"].lstrip("uintfloa")]
    return i * j * k * size / 1e6


def main():
    cli, scans = sys.argv[1], pathlib.Path(sys.argv[2])
    if not scans.is_dir():
        print(f"NOT CHECKED: the scans {scans.name} are not here")
        return 77
    wrong = []
    asked = 0
    for folder, entries in TABLE.items():
        for path in sorted((scans / folder).iterdir()):
            inside = f"{folder}/{path.name}"
            if inside in TABLE or path.name.endswith(NOT_ASKED) or path.name in NOT_ASKED_NAMES:
                continue
            if path.name not in entries:
                if path.name.startswith("LICENSE"):
                    continue
                wrong.append(f"{inside}: not in the table")
                continue
            said, code, seconds, megabytes, noise = info(cli, path)
            asked += 1
            verdict, expected = verdict_of(said), entries[path.name]
            if verdict != expected:
                wrong.append(f"{inside}: {verdict}, not {expected}")
            if code != (0 if expected.startswith(("sound", SEVERAL)) else 3):
                wrong.append(f"{inside}: exit code {code}")
            sentence = said.get("message") or said.get("error", {}).get("message", "")
            if expected != SEVERAL and not sentence.endswith("."):
                wrong.append(f"{inside}: no sentence, {sentence!r}")
            if noise:
                wrong.append(f"{inside}: prints {noise[0]!r}")
            if seconds > MOST_S:
                wrong.append(f"{inside}: {seconds:.1f} s")
            if megabytes > MOST_MB + MOST_PER_VOXEL_BYTE * voxel_mb(said):
                wrong.append(f"{inside}: {megabytes:.0f} MB for {voxel_mb(said):.0f} of voxels")
            if expected == TILTED:
                said, code, *_ = info(cli, path, "--correct")
                if verdict_of(said) != "corrected gantry-tilt" or code != 0:
                    wrong.append(f"{inside}: {verdict_of(said)} with --correct, code {code}")
            if expected == "refused missing-slices":
                said, code, *_ = info(cli, path, "--largest-part")
                if verdict_of(said) != "part missing-slices" or code != 0:
                    wrong.append(f"{inside}: {verdict_of(said)} with --largest-part, code {code}")
        for name in entries:
            if not (scans / folder / name).exists():
                wrong.append(f"{folder}/{name}: in the table and not here")
    print("\n".join(wrong) or f"{asked} scans and broken files are what they must be.")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
