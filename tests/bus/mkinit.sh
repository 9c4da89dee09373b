#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# mkinit.sh MODULES UDEV PROGRAM OUT: writes an initial file system for the guest, gzipped, to OUT: busybox,
# the kernel modules that the buses need, found anywhere below MODULES, the program, udevadm with the rules
# of Debian and Palpate's, from UDEV or from this machine, the libraries that both are linked with, and init.
set -eu
modules="$1" udev="$2" program="$3" out="$4"
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

set -- "$program"
udevadm="$(PATH="$udev/bin:$PATH" command -v udevadm || true)"
if [ -n "$udevadm" ]; then
  cp "$udevadm" "$root/bin/"
  mkdir -p "$root/lib/udev/rules.d"
  for rules in "$udev"/lib/udev/rules.d/*.rules /lib/udev/rules.d/*.rules "$here/../../packaging/70-palpate.rules"; do
    [ ! -f "$rules" ] || cp "$rules" "$root/lib/udev/rules.d/"
  done
  set -- "$program" "$udevadm"
fi
cp "$program" "$root/test/bus_test"
strip "$root/test/bus_test"
# "libusb-1.0.so.0 => /lib/x86_64-linux-gnu/libusb-1.0.so.0 (0x…)", and the loader without an arrow
ldd "$@" | grep -o '/[^ :]*' | grep -F .so | sort -u | while read -r library; do
  mkdir -p "$root$(dirname "$library")"
  cp -L "$library" "$root$library"
done

(cd "$root" && find . | busybox cpio -o -H newc 2> /dev/null | gzip -1) > "$out"
