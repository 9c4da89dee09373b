// SPDX-License-Identifier: BSD-3-Clause
// The sentences of the readers, in the order of the source.
#pragma once

#include "resources/messages/row.h"

namespace resources {

inline constexpr Row kReaders[] = {
    // compressed DICOM slices
    {"codestream-cut-off", "it is cut off"},
    {"codestream-continues-after-end", "more data follows its end"},
    {"codestream-components", "its %1 has %2 components, not one"},
    {"codestream-size-differs", "its %1 has %2 pixels and the header says %3"},
    {"codestream-depth-differs", "its %1 has values of %2 bits and the header says %3 of %4"},
    {"codestream-too-few-bytes", "its %1 bytes are too few for %2 pixels"},
    {"codestream-huffman-table", "its Huffman tables are no code"},
    {"codestream-value-table", "it maps its values through a table or states its size twice"},
    {"codestream-parameters-contradict", "its coding parameters contradict each other"},
    {"codestream-other-process",
     "it is coded by another JPEG process than its transfer syntax names"},
    {"codestream-depth-unknown", "its values have a depth that JPEG does not know"},
    {"codestream-frame-header", "its frame header is senseless"},
    {"codestream-data-before-size", "its coded data come before its size"},
    {"codestream-scan-header", "its scan header is senseless"},
    {"codestream-loss-undeclared", "it is coded with loss and its transfer syntax is lossless"},
    {"codestream-no-jpeg", "it does not begin like JPEG"},
    {"codestream-size-twice", "it states its size twice"},
    {"codestream-marker-out-of-place", "a marker stands in its header that has no place there"},
    {"codestream-broken-off", "its coded data are broken off by another marker"},
    {"codestream-sign-differs",
     "its JPEG 2000 image and the header differ on whether values have a sign"},
    {"codestream-high-throughput", "it is coded as High-Throughput JPEG 2000"},
    {"codestream-grid", "its pixels lie on another grid than an image's"},
    {"codestream-too-many-tiles", "it has more tiles than JPEG 2000 knows"},
    {"codestream-coding-style", "its coding style is senseless"},
    {"codestream-tiles-out-of-order", "its tiles do not follow each other"},
    {"codestream-no-jpeg-2000", "it does not begin like a JPEG 2000 codestream"},
    {"codestream-main-header-incomplete", "its main header is incomplete"},
    {"codestream-rle-segments", "its RLE table has %1 segments where %2 bits need %3"},
    {"codestream-rle-table", "its RLE table is senseless"},
    {"codestream-syntax-unknown", "its transfer syntax is not known here"},
    {"codestream-too-many-pixels", "it has %1 pixels, more than any slice does"},
    {"decoder-missing",
     "Compressed images are decoded by the program %1, which is not installed; install Palpate "
     "again, or export the images as explicit little endian."},
    {"decoder-no-memory",
     "Compressed images are decoded by the program %1, which could not be given memory; install "
     "Palpate again, or export the images as explicit little endian."},
    {"decoder-not-connected",
     "Compressed images are decoded by the program %1, which could not be connected; install "
     "Palpate again, or export the images as explicit little endian."},
    {"decoder-not-started",
     "Compressed images are decoded by the program %1, which could not be started; install Palpate "
     "again, or export the images as explicit little endian."},
    {"decoder-not-confined",
     "Compressed images are decoded by the program %1, which could not be confined to its work on "
     "this system; install Palpate again, or export the images as explicit little endian."},
    {"dicom-frames-damaged",
     "The compressed pixels of %1 are damaged or cut off; fetch the file again."},
    // DICOM
    {"dicom-number-unreadable",
     "The file %1 states a %2 that is not written as DICOM writes numbers (\"1.5\", with a point "
     "and without a unit), or too many or too few of them; export it again."},
    {"dicom-syntax-unnamed",
     "The images are stored in a transfer syntax (that is not known here) that cannot be decoded; "
     "export them as explicit little endian."},
    {"dicom-syntax-unknown",
     "The images are stored in a transfer syntax (%1) that cannot be decoded; export them as "
     "explicit little endian."},
    {"dicom-copied-as-text",
     "The file %1 was copied as if it were text, which put bytes among its pixels; copy it again "
     "in binary mode."},
    {"dicom-continues-after-pixels",
     "The file %1 goes on after its pixels with something that is no DICOM; copy or fetch it "
     "again."},
    {"dicom-pixels-missing",
     "A file of the series describes an image and ends without its pixels; fetch it again."},
    {"dicom-no-image-or-modality",
     "The series holds no image (modality not stated); choose the series of the scan."},
    {"dicom-no-image", "The series holds no image (modality %1); choose the series of the scan."},
    {"dicom-colour",
     "The series holds colour pictures, which have no isosurface; choose the series of the scan."},
    {"dicom-pixels-cut-off", "The file %1 ends before its pixels do; copy or fetch it again."},
    {"dicom-too-many-frames",
     "The file %1 states %2 frames, more than any scan has; export it again."},
    {"dicom-pixel-count-impossible",
     "The file %1 states a number of pixels or bits that no image has; export it again."},
    {"dicom-more-pixels-than-slices",
     "A file of the series holds more pixels than the slices it states; export it again, as one "
     "file per slice."},
    {"dicom-scout",
     "The series is a scout view for planning and no stack of slices; choose the series of the "
     "scan."},
    {"dicom-pixels-stored-otherwise",
     "The pixels of %1 are stored in another way than its transfer syntax says; export it again."},
    {"dicom-pixel-format",
     "A file of the series states %1 x %2 pixels of %3 bits, which is not an image that can be "
     "read."},
    {"dicom-place-missing",
     "The series does not say where its slices lie (position, orientation or pixel spacing is "
     "missing); export it again with its geometry."},
    {"dicom-value-table",
     "The file %1 maps its stored values through a table (Modality LUT), which is not done here; "
     "export it with a rescale slope and intercept."},
    {"dicom-rescale-incomplete",
     "The file %1 states one of rescale slope and intercept without the other; export it again."},
    {"dicom-rescale-slope-zero", "The file %1 states a rescale slope of 0; export it again."},
    {"dicom-sign-missing",
     "The file %1 does not say whether its pixels have a sign (Pixel Representation); export it "
     "again."},
    {"dicom-bits-impossible",
     "The file %1 states %2 stored of %3 bits, up to bit %4, which cannot be; export it again."},
    {"dicom-header-cut-off", "The header of %1 is damaged or cut off; copy or fetch it again."},
    {"dicom-header-unreadable", "The header of %1 cannot be understood; export it again."},
    {"dicom-fault-shared", "%(1) (%2 of %3 files)."},
    {"dicom-voxel-types-mixed",
     "The series mixes voxel types; put them into folders of their own."},
    {"dicom-acquisitions-interleaved",
     "The series holds several acquisitions whose slices lie between each other's, and it cannot "
     "be told which belong together; put each acquisition into a folder of its own."},
    {"dicom-no-series", "%1 is no DICOM file, or not any more; open the folder of one series."},
    {"dicom-index-or-no-image",
     "%1 holds no image: it is the index of a folder, or no DICOM after all; open the folder of "
     "one series."},
    {"file-fault", "%1: %2"},
    {"dicom-largest-part",
     "The largest part without a gap has %1 of the %2 slices that are there, from %3 to %4 mm "
     "along the stack."},
    {"dicom-one-stack", "One evenly spaced stack of %1 slices."},
    {"dicom-single-slice", "A single slice, taken to be as thick as it states."},
    {"dicom-single-slice-unstated",
     "A single slice of unstated thickness, taken to be 1 mm thick."},
    {"dicom-copy-left-out", "%(1); 1 other copy of a slice in the folder is left out."},
    {"dicom-copies-left-out", "%(1); %2 other copies of slices in the folder are left out."},
    {"dicom-pixels-undecodable",
     "The pixels of %1 cannot be decoded: they are cut off, damaged or in a form unknown here; "
     "fetch the file again or export it as explicit little endian."},
    {"dicom-frame-refused",
     "The compressed image in %1 cannot be shown: %2; fetch the file again or export it as "
     "explicit little endian."},
    {"dicom-frame-ends-decoder",
     "The compressed image in %1 is damaged in a way that its decoder does not bear; fetch the "
     "file again or export it as explicit little endian."},
    {"dicom-resampled-whole-only",
     "A series that is to be resampled is read whole or not at all; free memory by closing other "
     "programs."},
    {"dicom-rescaled-range", "The series' rescaled values fit no voxel type; export it again."},
    {"dicom-file-too-large",
     "%1 is or inflates to more than a scan's file should; export it uncompressed."},
    {"dicom-deflated-damaged",
     "The compressed data of %1 end early or are damaged; copy or fetch it again."},
    {"file-unreadable", "%1 cannot be read; copy or fetch it again."},
    {"dicom-position-or-spacing",
     "A slice of the series has a position or pixel spacing that is no positive number; export the "
     "series again."},
    {"dicom-orientation",
     "A slice of the series has an orientation that is not two perpendicular directions; export "
     "the series again."},
    {"dicom-sizes-mixed",
     "The series mixes slices of %1 x %2 and %3 x %4 pixels; put them into folders of their own."},
    {"dicom-orientations-mixed",
     "The series mixes slices that are turned against each other by up to %1 degrees; put each "
     "orientation into a folder of its own."},
    {"dicom-spacings-mixed",
     "The series mixes pixel spacings of %1 and %2 mm; put them into folders of their own."},
    {"dicom-positions-repeated",
     "%1 of %2 slices lie at the position of another one; keep one image of each position in the "
     "folder."},
    {"dicom-tilt-too-large",
     "The slices advance %1 degrees off the direction that they face, which no gantry does; export "
     "the series again."},
    {"dicom-slice-aside",
     "A slice of the series lies %1 mm beside the others; ask for a reconstruction as one straight "
     "stack."},
    {"dicom-slice-missing",
     "1 slice is missing from the series (%1 of %2 steps are a multiple of %3 mm); fetch the "
     "series again."},
    {"dicom-slices-missing",
     "%1 slices are missing from the series (%2 of %3 steps are a multiple of %4 mm); fetch the "
     "series again."},
    {"dicom-uneven",
     "The slices are unevenly spaced: %1 of %2 steps differ from %3 mm, from %4 to %5 mm."},
    {"dicom-tilted",
     "The slices are tilted by %1 degrees against the direction in which they advance."},
    {"dicom-tilted-and-uneven",
     "The slices are tilted by %1 degrees against the direction in which they advance, and "
     "unevenly spaced."},
    {"dicom-too-few-for-gaps",
     "%(1); there are too few of them to fill the gaps, so ask for a reconstruction with even "
     "spacing."},
    {"dicom-slices-aside",
     "%(1), and lie %2 pixels beside each other, which no scan does; export it again."},
    {"dicom-can-be-resampled",
     "%(1); they can be resampled onto a right-angled grid of even steps."},
    {"dicom-no-slice", "The series holds no slice."},
    {"dicom-header-too-deep",
     "The header of %1 nests more sequences, or has more elements out of order, than any scan's, "
     "or cannot be understood; export it again."},
    // archives, folders and files
    {"archive-too-large",
     "The archive %1 holds more than a study, or more than the disk for temporary files has room "
     "for; unpack it yourself and open the folder of one series."},
    {"archive-damaged", "The archive %1 is cut off or damaged; copy or fetch it again."},
    {"archive-locked",
     "The archive %1 is locked with a password; unpack it yourself and open the folder."},
    {"archive-kind-unread",
     "%1 is packed as %2, which is not unpacked here; unpack it yourself and open the folder, or "
     "pack it as ZIP."},
    {"file-packed",
     "%1 is packed by %2 and no archive is found in it; unpack it yourself and open what comes "
     "out."},
    {"archive-name-outside",
     "The archive %1 holds a name that leads out of it or too deep into it; unpack it yourself and "
     "open the folder."},
    {"temporary-folder-unwritable",
     "The folder for temporary files, \"%1\", cannot be written, and an archive is unpacked there; "
     "set TMPDIR to one that can be, or unpack the archive yourself."},
    {"data-file-outside-folder",
     "The header %1 names a data file outside its own folder; put both into one folder and name it "
     "without a path."},
    {"data-file-missing",
     "The data file %2 that the header %1 names is missing; copy it beside the header."},
    {"geometry-axis-empty", "The volume has an axis without voxels; its header is broken."},
    {"geometry-not-finite",
     "The volume's spacing, orientation or origin is not a number; export it again with its "
     "geometry."},
    {"geometry-spacing",
     "The volume's voxel spacing of %1 x %2 x %3 mm cannot be right; export it again with its "
     "geometry."},
    {"geometry-too-far",
     "The volume is said to lie %1 m away from the origin of its space, which cannot be right; "
     "export it again with its geometry."},
    {"geometry-sheared",
     "The volume's axes are %1 degrees off their right angles; resample it onto a right-angled "
     "grid first."},
    {"geometry-squared",
     "The axes are %1 degrees off their right angles, which is taken for rounding and set right."},
    {"folder-too-many-files",
     "The folder %1 holds more than %2 files; open the folder of one study."},
    {"voxels-not-mappable",
     "%1 cannot be opened without loading it whole; copy it to a disk of this machine, or read a "
     "part of it."},
    {"voxels-too-short", "%1 is too short for its voxels; copy or fetch it again."},
    {"part-step", "Every %1th voxel is none; take every second, say."},
    {"part-outside", "The box from %1 to %2 lies outside an axis of %3 voxels; choose one inside."},
    {"path-unreadable",
     "There is no file or folder %1 that can be read; check its name and its permissions."},
    {"loading-cancelled", "Loading was cancelled."},
    {"both-sentences", "%1 %2"},
    {"advice-close-programs", "close other programs"},
    {"memory-too-small-for-volume",
     "The volume needs %1 GB of memory and %2 GB are free; read every second voxel or a box of it, "
     "or %3."},
    {"advice-save-raw", "save it raw with a detached header"},
    {"advice-save-with-numbers", "save it with numbers in every voxel"},
    {"header-size-not-positive",
     "The header of %1 states a size that is no positive number; export it again."},
    {"header-too-many-voxels",
     "The header of %1 states more voxels than any memory holds; export it again."},
    {"file-too-many-volumes", "%1 holds %2 volumes; export fewer than %3 into one file."},
    {"file-shorter-than-header",
     "%1 is too short for the voxels that its header states; copy or fetch it again."},
    {"voxels-damaged", "The voxels of %1 end early or are damaged; copy or fetch the file again."},
    {"thumbnail-no-size", "The slice has no size."},
    // meshes
    {"mesh-vertex-not-finite", "A vertex of %1 is not a finite number; export the mesh again."},
    {"mesh-vertex-incomplete", "A vertex of %1 is not three numbers; export the mesh again."},
    {"stl-facet-in-facet", "%1 begins a facet inside a facet; export it again."},
    {"stl-facet-vertices",
     "A facet of %1 has %2 vertices and not three; export the mesh again as triangles."},
    {"stl-cut-off", "%1 ends before its solid does; copy it again."},
    {"stl-header-cut-off", "%1 ends within its header; copy it again."},
    {"stl-too-few-triangles",
     "%1 states %2 triangles and has room for %3; copy or export it again."},
    {"obj-face-index",
     "Face %1 of %2 has fewer than three corners or names a vertex that the file does not have; "
     "export the mesh again."},
    {"ply-header", "The header of %1 is not one of a PLY file; export the mesh again."},
    {"ply-cut-off", "%1 ends before its %2 rows of an element do; copy or export it again."},
    {"ply-face-index",
     "A face of %1 has fewer than three corners or names a vertex that the file does not have; "
     "export the mesh again."},
    {"mesh-format-unknown", "%1 is not a mesh that can be read; save the tool as STL, OBJ or PLY."},
    {"mesh-too-large", "%1 is larger than 1 GB; reduce the mesh first."},
    {"mesh-memory", "The memory of this machine does not hold %1; reduce the mesh first."},
    {"mesh-unreadable", "%1 cannot be read as a mesh; export it again as binary STL."},
    {"mesh-no-triangle", "%1 holds no triangle; a tool needs a surface, so export one."},
    {"mesh-open",
     "The mesh is open (%1 edges have one triangle); it is touched with its vertices all the "
     "same."},
    {"mesh-not-manifold",
     "The mesh is not manifold (%1 edges have more than two triangles); it is touched with its "
     "vertices all the same."},
    {"mesh-length-unusual",
     "The tool is %1 mm long, which is unusual; check the unit of the mesh."},
    // MetaImage
    {"header-too-long", "The header of %1 is longer than 1 MB; export it again."},
    {"meta-image-line", "The header of %1 has a line that is no key and value; export it again."},
    {"header-field-twice", "The header of %1 states a field twice; export it again."},
    {"meta-image-no-data-file", "The header of %1 names no data file; export it again."},
    {"meta-image-no-type", "The header of %1 states no ElementType; export it again."},
    {"volume-colours-or-vectors",
     "The voxels of %1 are colours or vectors; export a volume of one value per voxel."},
    {"volume-64-bit-integers",
     "The voxels of %1 are 64-bit integers, which cannot be shown or touched exactly; convert them "
     "to 32-bit integers or float."},
    {"meta-image-type-unknown", "The header of %1 states an unknown ElementType; export it again."},
    {"meta-image-no-dimensions", "The header of %1 states no NDims; export it again."},
    {"volume-axis-count", "%1 has %2 axes; export a volume of three."},
    {"header-no-numbers",
     "The header of %1 has something other than numbers (\"1.5\", with a point and without a unit) "
     "in \"%2\", or too many or too few of them; correct it or export it again."},
    {"header-no-whole-numbers",
     "The header of %1 has something other than whole numbers in \"%2\"; correct it or export it "
     "again."},
    {"header-no-sizes", "The header of %1 does not state a size of each axis; export it again."},
    {"meta-image-numbers",
     "The header of %1 does not state %2 numbers as its %3; export it again."},
    {"header-unit-unknown",
     "The header of %1 measures in a unit that is no length known here; export it again."},
    {"header-spacing-not-positive",
     "The header of %1 states a spacing that is not positive; export it again."},
    {"meta-image-directions",
     "The header of %1 states directions that are no unit vectors; export it again."},
    {"meta-image-slope",
     "The header of %1 rescales its voxels by a slope that makes no sense; export it again."},
    {"meta-image-text", "The voxels of %1 are text and no bytes; save them as binary data."},
    {"meta-image-several-files",
     "The voxels of %1 are spread over several files; save them as one."},
    {"meta-image-header-size",
     "The header of %1 states a HeaderSize that makes no sense; export it again."},
    {"meta-image-header-size-too-small",
     "The header of %1 states a HeaderSize that ends within it; export it again."},
    {"meta-image-bytes-unexplained",
     "The header of %1 says nothing of the %2 bytes that its data file holds beside the voxels; "
     "export it again."},
    // NIfTI
    {"nifti-voxel-size-contradicts",
     "The header of %1 states a size of its voxels that is not that of their type; export it "
     "again."},
    {"nifti-colours-or-complex",
     "The voxels of %1 are colours or complex numbers; export a volume of one value per voxel."},
    {"nifti-type",
     "The voxels of %1 are of a type that cannot be shown or touched exactly; convert them to "
     "32-bit integers or float."},
    {"nifti-axis-count",
     "The header of %1 states a number of axes that makes no sense; export it again."},
    {"nifti-vectors",
     "Axis %1 of %2, counted from 1, holds the components of vectors and no places; export a "
     "volume of one value per voxel."},
    {"nifti-voxels-placed",
     "The header of %1 places the voxels where none can be; export it again."},
    {"nifti-no-rotation",
     "The header of %1 states an orientation that is no rotation; export it again."},
    {"nifti-orientation-ambiguous",
     "The header of %1 places the voxels twice, by its qform and by its sform, and not alike; "
     "export it with one of them."},
    {"nifti-qform-used",
     "The axes of the sform are %1 degrees off their right angles, so the qform places the "
     "volume."},
    {"nifti-rescale",
     "The header of %1 rescales its voxels by what is no number; export it again."},
    {"nifti-no-beginning",
     "The header of %1 does not begin as that of a NIfTI file in one piece; export it again."},
    // NRRD
    {"nrrd-no-type", "The header of %1 states no type; export it again."},
    {"nrrd-blocks", "The voxels of %1 are blocks of bytes and no numbers; export a scalar volume."},
    {"nrrd-type-unknown", "The header of %1 states an unknown type; export it again."},
    {"nrrd-axis-kind",
     "Axis %1 of %2, counted from 0, is of kind %3 and holds no places; export a volume of three "
     "axes and one value per voxel."},
    {"nrrd-no-kinds", "The header of %1 does not state a kind of each axis; export it again."},
    {"nrrd-four-places",
     "The header of %1 calls %2 of its four axes places, by direction or by kind; export it with "
     "three of them and one that counts volumes."},
    {"nrrd-no-dimension", "The header of %1 states no dimension; export it again."},
    {"nrrd-dimension",
     "The dimension of %1 is %2; only volumes of three axes and one value per voxel can be loaded, "
     "one or several in a file, so export one such volume."},
    {"nrrd-no-sizes", "The header of %1 states no sizes; export it again."},
    {"nrrd-no-encoding", "The header of %1 states no encoding; export it again."},
    {"nrrd-encoding-unknown",
     "The voxels of %1 are in an encoding that is unknown here; save them as raw or gzip."},
    {"nrrd-no-byte-order", "The header of %1 does not state the byte order; export it again."},
    {"nrrd-skips",
     "The header of %1 skips a number of lines or bytes that makes no sense; export it again."},
    {"nrrd-ends-with-header", "%1 ends with its header; fetch it again whole."},
    {"nrrd-data-file-names",
     "The header of %1 names its data files in a way that cannot be followed; export it again."},
    {"nrrd-data-file-count",
     "The header of %1 names %2 data files, which cannot share its %3 voxels evenly; complete the "
     "list or export it again."},
    {"nrrd-bytes-unexplained",
     "The data file of %1 holds %2 bytes more than its voxels need and the header does not say "
     "which; add a byte skip to the header."},
    {"nrrd-data-cut-off",
     "%1 is too short for the %2 voxels that its header states; copy or fetch it again."},
    {"nrrd-no-magic",
     "%1 is no NRRD file: it does not begin with NRRD0001 to NRRD0005. Open the file itself, or "
     "export it again."},
    {"nrrd-too-many-files", "The header of %1 lists too many files; export it again."},
    {"nrrd-field-too-long", "The header of %1 has a field that is too long; export it again."},
    {"nrrd-unit-unknown",
     "The header of %1 measures its axes in a unit that is no length known here; export it in "
     "millimetres."},
    {"nrrd-units-differ",
     "The header of %1 measures its axes in different units; export it in millimetres."},
    {"nrrd-axis-no-direction",
     "An axis of %1 has no direction in space; export it again with its geometry."},
    {"nrrd-space-dimension",
     "The header of %1 places its axes in a space of %2 dimensions; export it with a space of "
     "three, such as left-posterior-superior."},
    {"nrrd-spacing-contradicts-axis",
     "The header of %1 states spacings that do not lead from its axis mins to its axis maxs; "
     "export it again with its geometry."},
    {"nrrd-spacing-missing",
     "The header of %1 does not state the spacing of every axis; export it again with its "
     "geometry."},
    {"nrrd-header-unreadable", "The header of %1 cannot be understood; export the volume again."},
    {"nrrd-ends-within-skip",
     "%1 ends within what its header says to skip; copy or fetch it again."},
    {"nrrd-value-unreadable",
     "Voxel %1 of %2 is written as something that is no value of its type; export it again as "
     "raw."},
    {"nrrd-nothing-read", "No NRRD file has been read yet."},
    // any volume, file or folder
    {"volume-evenly-spaced", "One evenly spaced stack."},
    {"volume-orientation-unknown",
     "The file does not state its orientation: left and right are unknown, and its spacing is "
     "taken to be in millimetres."},
    {"volume-orientation-and-spacing-unknown",
     "The file states neither orientation nor spacing: left and right are unknown, and voxels of 1 "
     "mm are assumed."},
    {"volume-spacing-unknown", "The file states no spacing: voxels of 1 mm are assumed."},
    {"volume-numbered", "Volume %1 of %2, counted from 0. %3"},
    {"memory-too-small-for-series",
     "The memory of this machine does not hold %1; close other programs or try a smaller series."},
    {"path-not-read", "%1 cannot be read; copy it to another folder and try again."},
    {"series-listed", "%1 is %2, %3, %4 mm"},
    {"series-listed-correctable", "%1 is %2, %3, %4 mm, correctable (%5)"},
    {"series-listed-refused", "%1 is %2, %3, refused (%4)"},
    {"series-no-modality", "of no modality"},
    {"series-and-next", "%1; %2"},
    {"series-and-more", "%1; and %2 more"},
    {"series-unknown", "%1 has no series %2: %3."},
    {"series-several", "%1 holds %2 series that can be loaded; name one: %3."},
    {"series-none-loadable", "None of the %1 series in %2 can be loaded; the first: %3"},
    {"folder-too-many-volumes",
     "The folder holds more volumes than can be listed; open this file by itself."},
    {"folder-empty-file",
     "1 empty file lies beside the slices; if the series lacks some, copy it again."},
    {"folder-empty-files",
     "%1 empty files lie beside the slices; if the series lacks some, copy it again."},
    {"folder-damaged-file",
     "1 damaged DICOM file lies beside the slices and may be one of them; copy the folder again."},
    {"folder-damaged-files",
     "%1 damaged DICOM files lie beside the slices and may be one of them; copy the folder again."},
    {"folder-forbidden-file",
     "1 file beside the slices may not be read; if the series lacks some, change their "
     "permissions."},
    {"folder-forbidden-files",
     "%1 files beside the slices may not be read; if the series lacks some, change their "
     "permissions."},
    {"folder-no-scan",
     "The folder %1 holds no scan that is known here (DICOM, NRRD, MetaImage or NIfTI); open the "
     "folder of a series."},
    {"archive-no-scan",
     "The archive %1 holds no scan that is known here (DICOM, NRRD, MetaImage or NIfTI); open the "
     "folder of a series."},
    {"path-forbidden", "%1 may not be read by this user; change its permissions or copy it."},
    {"file-no-scan",
     "%1 is no DICOM, NRRD, MetaImage or NIfTI file; open the folder of a DICOM series, one of its "
     "files, or an .nrrd, .nhdr, .mhd, .mha, .nii or .nii.gz file."},
};

}  // namespace resources
