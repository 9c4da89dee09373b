// SPDX-License-Identifier: BSD-3-Clause
// The sentences of the drivers, in the order of the source.
#pragma once

#include "resources/messages/row.h"

namespace resources {

inline constexpr Row kDrivers[] = {
    {"capstan-which-arm",
     "Polhem and WoodenHaptics have the same boards: connect the arm that it is, or it is pushed "
     "in wrong directions."},
    {"capstan-not-plugged-in",
     "No %1 is plugged in; switch its power on and plug its USB cable in."},
    {"capstan-lost", "The %1 went away; plug it in again."},
    {"capstan-firmware-old",
     "The board of the %1 has firmware of before October 2019, which is not supported; load a "
     "newer one of its makers."},
    {"capstan-no-answer",
     "What is plugged in does not answer as a %1 does; switch its power on, or unplug the other "
     "device that has its USB ids."},
    {"device-unknown",
     "There is no device '%1'; `palpate-cli devices` lists those that are known."},
    {"falcon-lost-while-opened",
     "The Novint Falcon was lost while it was opened; plug it in again, best into the computer "
     "itself, and open it again."},
    {"falcon-not-plugged-in",
     "No Novint Falcon is plugged in; plug in its USB cable and its power supply."},
    {"falcon-not-permitted",
     "The system does not let you use the Novint Falcon; install Palpate's rules for devices, "
     "70-palpate.rules, and plug it in again."},
    {"falcon-in-use", "The Novint Falcon is in use; close the program that has it."},
    {"falcon-firmware-unreadable",
     "The Novint Falcon's firmware file '%1' cannot be read; choose the one that came with the "
     "Falcon's own software."},
    {"falcon-firmware-empty",
     "The Novint Falcon's firmware file '%1' is empty; choose the one that came with the Falcon's "
     "own software."},
    {"falcon-firmware-too-large",
     "The Novint Falcon's firmware file '%1' is larger than the Falcon's memory; choose the one "
     "that came with the Falcon's own software."},
    {"falcon-no-firmware",
     "The Novint Falcon has had no firmware since it was switched on; choose the firmware file "
     "that came with the Falcon's own software."},
    {"falcon-no-answer",
     "The Novint Falcon does not answer; see that its power supply is plugged in, switch it off "
     "and on, and open it again."},
    {"falcon-firmware-not-taken",
     "The Novint Falcon did not take its firmware whole; plug it into a port of the computer "
     "itself, or into a hub with a power supply, and open it again."},
    {"falcon-firmware-not-running",
     "The Novint Falcon took '%1', but does not run it; switch it off and on, and choose the "
     "firmware file that came with the Falcon's own software."},
    {"falcon-in-use-elsewhere",
     "Another program uses the Novint Falcon; close that program first."},
    {"falcon-gone",
     "The Novint Falcon is not plugged in, or not where it was; plug in its USB cable and its "
     "power supply."},
    {"falcon-not-opened",
     "The Novint Falcon could not be opened (%1); unplug it and plug it in again."},
    {"force-dimension-install-library",
     "install it from its maker's site, where the system looks for libraries."},
    {"force-dimension-library-old",
     "The Force Dimension SDK is too old (%1 lacks %2); install a newer one from its maker's "
     "site."},
    {"force-dimension-library-version",
     "The Force Dimension SDK is of version %1.%2.%3, and Palpate knows 3.3.2 to 3.x; install one "
     "of these from its maker's site."},
    {"force-dimension-model-unknown",
     "The Force Dimension device is of model number %1, which Palpate does not know; tell its "
     "makers the number."},
    {"force-dimension-no-watchdog",
     "The %1 does not take a watchdog, without which its force would stay on when a program dies; "
     "update its firmware."},
    {"force-dimension-in-use",
     "Another program uses the Force Dimension device; close that program first."},
    {"force-dimension-not-permitted",
     "The system does not let you use the Force Dimension device; install Palpate's rules for "
     "devices, 70-palpate.rules, and plug it in again."},
    {"force-dimension-gone", "The Force Dimension device is gone; plug it in and switch it on."},
    {"force-dimension-no-answer",
     "The Force Dimension device does not answer; switch it on, and see that Palpate's rules for "
     "devices, 70-palpate.rules, are installed."},
    {"force-dimension-not-opened",
     "The Force Dimension device could not be opened (error %1); switch it off and on again."},
    {"force-dimension-not-found",
     "No Force Dimension device is found; plug it in and switch it on."},
    {"force-dimension-open", "Palpate has a Force Dimension device open."},
    {"force-dimension-model-told-later", "Opening it tells which model it is."},
    {"force-dimension-open-already",
     "Palpate has a Force Dimension device open; close that one first."},
    {"hid-not-permitted",
     "The system does not let you use the %1; install Palpate's rules for devices, "
     "70-palpate.rules, and plug it in again."},
    {"hid-in-use",
     "Another program, or another part of Palpate, uses the %1; close that one first."},
    {"hid-gone", "The %1 is gone; plug it in again."},
    {"hid-not-opened", "The %1 could not be opened; unplug it and plug it in again."},
    {"inverse3-no-power", "The Haply Inverse3 has no power; plug in its power supply."},
    {"inverse3-not-started", "The Haply Inverse3 is not started; switch it off and on, and wait."},
    {"inverse3-not-ready", "The Haply Inverse3 is not ready; wait, or switch it off and on."},
    {"inverse3-not-calibrated",
     "The Haply Inverse3 is not calibrated; put its handle in the inkwell until its light says "
     "that it is."},
    {"inverse3-no-service",
     "The service of the Haply Inverse3 does not answer; install and start its maker's "
     "haply-inverse-service."},
    {"inverse3-service-unknown",
     "The service of the Haply Inverse3 speaks in a way that Palpate does not know; install "
     "version 3.5 of haply-inverse-service."},
    {"inverse3-not-plugged-in",
     "No Haply Inverse3 is connected; plug in its cable and its power supply, and look for it in "
     "Haply Hub."},
    {"inverse3-other-axes",
     "The Haply Inverse3 %1 is set to other axes than its maker's; set its basis to XYZ in Haply "
     "Hub."},
    {"openhaptics-install-library",
     "install it and the device's driver from 3D Systems' site, where the system looks for "
     "libraries."},
    {"openhaptics-library-old",
     "OpenHaptics is too old (%1 lacks %2); install a newer one from 3D Systems' site."},
    {"openhaptics-in-use", "Another program uses the Touch or PHANTOM; close that program first."},
    {"openhaptics-no-licence",
     "OpenHaptics finds no valid licence; run its licence tool, or install the developer edition "
     "from 3D Systems' site."},
    {"openhaptics-no-answer",
     "The Touch or PHANTOM does not answer; see that it is plugged in and switched on, that "
     "Palpate's rules for devices, 70-palpate.rules, are installed, and pair it in the maker's "
     "setup tool."},
    {"openhaptics-not-found",
     "OpenHaptics finds no Touch or PHANTOM; plug it in, switch it on, and set it up with the "
     "maker's setup tool."},
    {"openhaptics-not-opened",
     "OpenHaptics could not open the Touch or PHANTOM (error %1); try the maker's diagnostic "
     "tool."},
    {"openhaptics-open", "Palpate has a Touch or PHANTOM open."},
    {"openhaptics-installed", "OpenHaptics is installed; opening tells whether a device is there."},
    {"openhaptics-open-already", "Palpate has a Touch or PHANTOM open; close that one first."},
    {"force-dimension-product", "The Force Dimension SDK"},
    {"library-not-loadable", "%1: %2 cannot be loaded (%3); %4"},
    {"library-not-installed", "%1 is not installed (looked for %2); %3"},
    {"space-mouse-not-plugged-in", "No SpaceMouse is plugged in; plug it or its receiver in."},
    {"spacenav-no-answer",
     "The service spacenavd does not answer at '%1'; start it, or use the SpaceMouse without it."},
    {"spacenav-not-permitted",
     "The system does not let you use the service spacenavd at '%1'; let your user read and write "
     "that socket."},
};

}  // namespace resources
