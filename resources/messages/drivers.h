// SPDX-License-Identifier: BSD-3-Clause
// The sentences of the drivers, in the order of the source.
#pragma once

#include "resources/messages/row.h"

namespace resources {

inline constexpr Row kDrivers[] = {
    {"capstan-which-arm",
     "Polhem and WoodenHaptics have the same boards: connect the arm that it is, or it is pushed "
     "in wrong directions.",
     "needs-calibration"},
    {"device-not-plugged-in", "No %1 is plugged in; plug in its cables, and switch it on.",
     "not-plugged-in"},
    {"device-gone", "The %1 is gone; plug it in again.", "not-plugged-in"},
    {"capstan-firmware-old",
     "The board of the %1 has firmware of before October 2019, which is not supported; load a "
     "newer one of its makers.",
     "no-firmware"},
    {"capstan-no-answer",
     "What is plugged in does not answer as a %1 does; switch its power on, or unplug the other "
     "device that has its USB ids.",
     "refused"},
    {"device-unknown", "There is no device '%1'; `palpate-cli devices` lists those that are known.",
     "unknown-device"},
    {"falcon-firmware-unusable",
     "The Novint Falcon's firmware file '%1' is empty, too large or cannot be read; choose the one "
     "that came with the Falcon's own software.",
     "no-firmware"},
    {"falcon-no-firmware",
     "The Novint Falcon has had no firmware since it was switched on; choose the firmware file "
     "that came with the Falcon's own software.",
     "no-firmware"},
    {"falcon-no-answer",
     "The Novint Falcon does not answer; see that its power supply is plugged in, switch it off "
     "and on, and open it again.",
     "refused"},
    {"falcon-firmware-not-taken",
     "The Novint Falcon did not take its firmware whole; plug it into a port of the computer "
     "itself, or into a hub with a power supply, and open it again.",
     "no-firmware"},
    {"falcon-firmware-not-running",
     "The Novint Falcon took '%1', but does not run it; switch it off and on, and choose the "
     "firmware file that came with the Falcon's own software.",
     "no-firmware"},
    {"force-dimension-library-version",
     "The Force Dimension SDK is of version %1.%2.%3, and Palpate knows 3.3.2 to 3.x; install one "
     "of these from its maker's site.",
     "no-library"},
    {"force-dimension-model-unknown",
     "The Force Dimension device is of model number %1, which Palpate does not know; tell its "
     "makers the number.",
     "unknown-device"},
    {"force-dimension-no-watchdog",
     "The %1 does not take a watchdog, without which its force would stay on when a program dies; "
     "update its firmware.",
     "no-firmware"},
    {"force-dimension-no-answer",
     "The Force Dimension device does not answer; switch it on, and see that Palpate's rules for "
     "devices, 70-palpate.rules, are installed.",
     "refused"},
    {"force-dimension-model-told-later", "Opening it tells which model it is."},
    {"device-not-permitted",
     "The system does not let you use the %1; install Palpate's rules for devices, "
     "70-palpate.rules, and plug it in again.",
     "no-permission"},
    {"device-in-use",
     "Another program, or another part of Palpate, uses the %1; close that one first.", "in-use"},
    {"device-not-opened",
     "The %1 could not be opened (%2); switch it off and on, or unplug it and plug it in again.",
     "refused"},
    {"inverse3-no-power", "The Haply Inverse3 has no power; plug in its power supply.", "refused"},
    {"inverse3-not-ready", "The Haply Inverse3 is not ready; wait, or switch it off and on.",
     "refused"},
    {"inverse3-not-calibrated",
     "The Haply Inverse3 is not calibrated; put its handle in the inkwell until its light says "
     "that it is.",
     "needs-calibration"},
    {"inverse3-no-service",
     "The service of the Haply Inverse3 does not answer; install and start its maker's "
     "haply-inverse-service.",
     "no-service"},
    {"inverse3-service-unknown",
     "The service of the Haply Inverse3 speaks in a way that Palpate does not know; install "
     "version 3.5 of haply-inverse-service.",
     "no-service"},
    {"inverse3-not-plugged-in",
     "No Haply Inverse3 is connected; plug in its cable and its power supply, and look for it in "
     "Haply Hub.",
     "not-plugged-in"},
    {"inverse3-other-axes",
     "The Haply Inverse3 %1 is set to other axes than its maker's; set its basis to XYZ in Haply "
     "Hub.",
     "refused"},
    {"openhaptics-no-licence",
     "OpenHaptics finds no valid licence; run its licence tool, or install the developer edition "
     "from 3D Systems' site.",
     "no-library"},
    {"openhaptics-no-answer",
     "The Touch or PHANTOM does not answer; see that it is plugged in and switched on, that "
     "Palpate's rules for devices, 70-palpate.rules, are installed, and pair it in the maker's "
     "setup tool.",
     "refused"},
    {"openhaptics-not-found",
     "OpenHaptics finds no Touch or PHANTOM; plug it in, switch it on, and set it up with the "
     "maker's setup tool.",
     "not-plugged-in"},
    {"openhaptics-installed", "OpenHaptics is installed; opening tells whether a device is there."},
    {"force-dimension-product", "The Force Dimension SDK"},
    {"library-not-loadable",
     "%1: %2 cannot be loaded (%3); install it from its maker's site, where the system looks for "
     "libraries.",
     "no-library"},
    {"library-not-installed",
     "%1 is not installed (looked for %2); install it from its maker's site, where the system "
     "looks for libraries.",
     "no-library"},
    {"spacenav-no-answer",
     "The service spacenavd does not answer at '%1'; start it, or use the SpaceMouse without it.",
     "no-service"},
    {"spacenav-not-permitted",
     "The system does not let you use the service spacenavd at '%1'; let your user read and write "
     "that socket.",
     "no-permission"},
    {"device-open", "Palpate has the %1 open; disconnect it first.", "in-use"},
    {"force-dimension-device", "Force Dimension device"},
    {"openhaptics-device", "Touch or PHANTOM"},
    {"library-old", "%1 is too old (%2 lacks %3); install a newer one from its maker's site.",
     "no-library"},
};

}  // namespace resources
