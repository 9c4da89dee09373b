#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a new user does first, with the installed program: starts it from the menu, reads the notice, tries
the demo skull, takes the tool and moves it on the bone with the mouse.

Usage: first_touch.py BEGUN (on a display, in a session bus)

BEGUN is when the installation ended, in seconds since 1970. The last line is how many seconds later the
first touch was. The program is watched and operated through AT-SPI, as by an assistive technology, so its own words
say when it touches.
"""
import os
import signal
import subprocess
import sys
import time

import gi
gi.require_version("Atspi", "2.0")
gi.require_version("Gio", "2.0")
from gi.repository import Atspi, Gio, GLib  # noqa: E402

LONG = 180  # s: far more than it takes on a machine that is busy
BEGUN = float(sys.argv[1])
heard = []  # names that changed


def hear(event):
    try:
        heard.append(event.source.get_name())
    except GLib.Error:
        pass  # it is gone meanwhile


def pump():
    end = time.monotonic() + 0.2
    while GLib.MainContext.default().iteration(False) and time.monotonic() < end:
        pass


def wait(what, found):
    """What `found` returns as soon as it is something."""
    end = time.monotonic() + LONG
    while time.monotonic() < end:
        pump()
        try:
            result = found()
        except GLib.Error:
            result = None  # the tree changed while it was read
        if result:
            return result
        time.sleep(0.1)
    for part in parts(program()):
        print("  there is:", part.get_role_name(), repr(part.get_name()))
    raise AssertionError(f"waited in vain for: {what}; heard last: {heard[-20:]}")


def program():
    desktop = Atspi.get_desktop(0)
    for index in range(desktop.get_child_count()):
        child = desktop.get_child_at_index(index)
        if child is not None and child.get_name() == "Palpate":
            return child
    raise GLib.Error("not there yet")


def parts(root):
    """Everything below `root` that is on the screen."""
    for index in range(root.get_child_count()):
        child = root.get_child_at_index(index)
        if child is not None and child.get_state_set().contains(Atspi.StateType.SHOWING):
            yield child
            yield from parts(child)


def find(role, name):
    return next((part for part in parts(program()) if part.get_role_name() == role and
                 part.get_name().startswith(name)), None)


def step(what):
    print(f"   {time.time() - BEGUN:5.1f} s: {what}", flush=True)


def press(name):
    button = wait(f"the button '{name}'", lambda: find("push button", name) or find("check box", name))
    step(name)
    assert Atspi.Action.do_action(button, 0), name


def touched():
    return any("Touching at" in name for name in heard)


def touch():
    """From the start page to the first force, with the mouse as the hand."""
    press("OK")  # the notice of the first start
    press("Try it")
    view = wait("the skull", lambda: find("canvas", "3-D view: surface at"))
    press("Skip")  # the bubbles of the first steps
    press("Take tool")
    box = Atspi.Component.get_extents(view, Atspi.CoordType.SCREEN)
    x, y = box.x + box.width // 2, box.y + box.height // 2
    Atspi.generate_mouse_event(x, y, "abs")
    Atspi.generate_mouse_event(x, y, "b1p")

    def pushed():
        Atspi.generate_mouse_event(x + int(time.time() * 10) % 9, y, "abs")
        Atspi.generate_mouse_event(x, y, "b4c")  # the wheel: towards the bone
        return touched()

    wait("a touch", pushed)
    Atspi.generate_mouse_event(x, y, "b1r")
    step("the first touch")


def ended(process):
    os.kill(process, signal.SIGTERM)
    end = time.monotonic() + LONG
    while time.monotonic() < end and os.path.exists(f"/proc/{process}/exe"):
        time.sleep(0.1)
    assert not os.path.exists(f"/proc/{process}/exe"), "the window does not close"


assert Atspi.init() in (0, 1)
listener = Atspi.EventListener.new(hear)
assert listener.register("object:property-change:accessible-name")
subprocess.run(["gtk-launch", "palpate"], check=True)
window = wait("the window", program).get_process_id()
step("the window is there")
touch()
took = time.time() - BEGUN
ended(window)

# the menu's own way to the skull: a simulated hand touches by itself, and no notice is in the way
heard.clear()
assert Gio.DesktopAppInfo.new("palpate.desktop").launch_action("demo", None) is None
window = wait("the window of the menu's action", program).get_process_id()
wait("a touch by the simulated hand", touched)
ended(window)
print(f"{took:.1f}")
