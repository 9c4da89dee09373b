#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# mkinit.sh MODULES PROGRAM OUT: writes an initial file system for the guest, gzipped, to OUT: busybox,
# the kernel modules that the buses need, found anywhere below MODULES, the program with the libraries
# that it is linked with, and init.
set -eu
modules="$1" program="$2" out="$3"
here="$(cd "$(dirname "$0")" && pwd)"
root="$(mktemp -d)"
trap 'rm -rf "$root"' EXIT
chmod 755 "$root"

mkdir -p "$root/bin" "$root/modules" "$root/test"
cp "$(command -v busybox)" "$root/bin/busybox"
ln -s busybox "$root/bin/sh"
cp "$here/init" "$root/init"
chmod 755 "$root/init"

# in the order in which one needs another
for module in usb-common usbcore hid hid-generic usbhid ff-memless hid-logitech uhid usbip-core \
  vhci-hcd; do
  found="$(find "$modules" -name "$module.ko" | head -n 1)"
  [ -n "$found" ] || {
    echo "This kernel's package has no module '$module'." >&2
    exit 1
  }
  cp "$found" "$root/modules/"
  echo "$module" >> "$root/modules/order"
done

cp "$program" "$root/test/bus_test"
strip "$root/test/bus_test"
# "libusb-1.0.so.0 => /lib/x86_64-linux-gnu/libusb-1.0.so.0 (0x…)", and the loader without an arrow
ldd "$program" | grep -o '/[^ ]*' | while read -r library; do
  mkdir -p "$root$(dirname "$library")"
  cp -L "$library" "$root$library"
done

(cd "$root" && find . | busybox cpio -o -H newc 2> /dev/null | gzip -1) > "$out"
