#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The window as a screen reader has it, and the first touch by keyboard alone.

The real program runs on a display and a session bus of its own. What it says is read through
AT-SPI; keys are pressed as a keyboard presses them.

Use: screen_reader_test.py PALPATE
Exit 77 (skipped) where AT-SPI, its Python or a display is absent.
"""
import ctypes
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

INSIDE = "PALPATE_SCREEN_READER_TEST"
LONG = 180  # s: far more than it takes on a machine that is busy


def skipped(why):
    print(f"SKIPPED: {why}")
    sys.exit(77)


if len(sys.argv) != 2:
    sys.exit(__doc__)
for needed in ("dbus-run-session", "xvfb-run"):
    if shutil.which(needed) is None:
        skipped(f"{needed} is not installed (packaging/dependencies)")
if not pathlib.Path("/usr/libexec/at-spi-bus-launcher").exists():
    skipped("at-spi2-core is not installed (packaging/dependencies)")
try:
    import gi
    gi.require_version("Atspi", "2.0")
    from gi.repository import Atspi, GLib
except (ImportError, ValueError) as error:
    skipped(f"{error} (packaging/dependencies: python3-gi, gir1.2-atspi-2.0)")

if INSIDE not in os.environ:
    # a display and a bus that nobody else uses; the bus starts what presses the keys, on that display
    os.environ[INSIDE] = "1"
    os.execvp("xvfb-run", ["xvfb-run", "-a", "-s", "-screen 0 1280x900x24 -noreset", "dbus-run-session", "--",
                           sys.executable, *sys.argv])

BEGUN = time.monotonic()
CONTEXT = GLib.MainContext.default()
heard = []  # what was said: kind, the new name, its source
renamed = []  # the parts whose new name has yet to be asked for
slices = set()  # what they show changes with the tool: heard once each
focus = None  # the part that has it, as it was said


def hear(event):
    """Asks nothing: an answer may take the program as long as a picture, and more is said meanwhile."""
    global focus
    if event.type.startswith("object:property-change:accessible-name"):
        if event.source not in slices and event.source not in renamed:
            renamed.append(event.source)
    elif event.type.startswith("object:state-changed:focused") and event.detail1:
        focus = event.source
    elif event.type.startswith("object:property-change:accessible-value"):
        heard.append((event.type, "", event.source))


def pump(seconds=0.2):
    """Hears what is said in this time, and asks once for each name that is new."""
    end = time.monotonic() + seconds
    GLib.timeout_add(int(1e3 * seconds), lambda: False)
    while time.monotonic() < end:
        CONTEXT.iteration(True)
    for source in renamed.copy():
        renamed.remove(source)
        try:
            name = source.get_name()
        except GLib.Error:
            continue  # it is gone meanwhile
        heard.append(("object:property-change:accessible-name", name, source))
        if " slice: " in name:
            slices.add(source)


def wait(what, found):
    """What `found` returns as soon as it is something."""
    end = time.monotonic() + LONG
    while time.monotonic() < end:
        try:
            result = found()
        except GLib.Error:
            result = None  # the tree changed while it was read
        if result:
            return result
        pump(0.05)
    for kind, name, _ in heard[-40:]:
        print("  heard:", kind, name)
    raise AssertionError(f"waited in vain for: {what}")


def parts(root):
    """Everything below `root` that is on the screen."""
    for index in range(root.get_child_count()):
        child = root.get_child_at_index(index)
        if child is None or not child.get_state_set().contains(Atspi.StateType.VISIBLE):
            continue
        yield child
        if child.get_role_name() != "table":
            yield from parts(child)


known = []  # the parts that were there at the last walk: a walk takes seconds on a machine that is busy


def find(role, name):
    """The part with this role whose name begins so."""
    def found():
        return next((part for part in known if part.get_role_name() == role and part.get_name().startswith(name) and
                     part.get_state_set().contains(Atspi.StateType.SHOWING)), None)
    part = found()
    if part is None:
        known[:] = parts(program())
        part = found()
    return part


def the(role, name):
    return wait(f"{role} '{name}'", lambda: find(role, name))


def program():
    desktop = Atspi.get_desktop(0)
    for index in range(desktop.get_child_count()):
        child = desktop.get_child_at_index(index)
        if child is not None and child.get_name() == "Palpate":
            return child
    raise GLib.Error("not there yet")


def labelled(part):
    """The names of its labels, where it has labels of their own."""
    return [relation.get_target(index).get_name() for relation in part.get_relation_set()
            if relation.get_relation_type() == Atspi.RelationType.LABELLED_BY
            for index in range(relation.get_n_targets())]


KEYS = {"Tab": 0xff09, "Escape": 0xff1b, "Down": 0xff54, "Up": 0xff52, "Return": 0xff0d, "space": 0x20}


def press(key):
    assert Atspi.generate_keyboard_event(KEYS[key], None, Atspi.KeySynthType.SYM), key


def tab_to(role, wanted):
    """Presses Tab until the part is reached; each press waits for the focus to go on."""
    for _ in range(120):
        now = focus
        if now.get_role_name() == role and wanted(now):
            return now
        press("Tab")
        wait("the focus goes on", lambda: focus is not now)
    raise AssertionError(f"Tab reaches no {role}")


def said(words, after=0):
    return [name for kind, name, _ in heard[after:] if kind.startswith("object:property-change:accessible-name")
            and words in name]


def said_by(words, after):
    return next(source for kind, name, source in heard[after:]
                if kind.startswith("object:property-change:accessible-name") and name.startswith(words))


def step(what):
    print(f"{time.monotonic() - BEGUN:6.1f} s: {what}", flush=True)


def value_of(part):
    return Atspi.Value.get_current_value(part)


def main():
    listener = Atspi.EventListener.new(hear)
    for kind in ("object:property-change:accessible-name", "object:property-change:accessible-value",
                 "object:state-changed:focused"):
        assert listener.register(kind)
    wait("the scan in the window", find_window)
    wait("the keyboard", take_keyboard)

    # the force is said, and so is what the views show
    wait("the state of the force", lambda: find("notification", "State of the force: Force"))
    view = the("canvas", "3-D view: surface at 300 HU")
    assert view.get_name().endswith("HU"), view.get_name()
    axial = the("canvas", "Axial slice: ")
    assert " mm" in axial.get_name(), axial.get_name()

    step("reads and sets the isovalue")
    # the isovalue in HU: not the steps of a slider
    slider = the("slider", "Isovalue")
    assert slider.get_name() == "Isovalue in HU", slider.get_name()
    assert value_of(slider) == 300.0, value_of(slider)
    least, most = Atspi.Value.get_minimum_value(slider), Atspi.Value.get_maximum_value(slider)
    assert -2000.0 < least < 300.0 < most < 5000.0 and most != 4096.0, (least, most)
    typed = the("spin button", "Isovalue, typed")
    assert value_of(typed) == 300.0
    before = len(heard)
    Atspi.Value.set_current_value(slider, 412.0)
    wait("the isovalue follows", lambda: value_of(slider) == 412.0 and value_of(typed) == 412.0)
    the("canvas", "3-D view: surface at 412 HU")
    wait("the value is told", lambda: any(kind.startswith("object:property-change:accessible-value")
                                          and source == slider for kind, _, source in heard[before:]))
    stiffness = the("slider", "Stiffness in N/m")
    assert value_of(stiffness) == 1000.0, value_of(stiffness)

    # no part of the window that takes the focus is without a name
    for part in parts(program()):
        states = part.get_state_set()
        if states.contains(Atspi.StateType.FOCUSABLE) and states.contains(Atspi.StateType.SHOWING):
            assert part.get_name() or part.get_role_name() in ("filler", "layered pane", "text", "scroll pane"), \
                (part.get_role_name(), part.get_description())

    # from here on pictures are drawn all the time, and each answer waits for one: the tree is walked no more
    step("touches")
    # the first touch, by keys alone: another hand is chosen in its list
    hands = tab_to("combo box", lambda part: labelled(part) == ["Hand"])
    before = len(heard)
    press("Down")
    wait("the simulated hand", lambda: hands.get_name() == "Simulated: tap")
    wait("a force is said", lambda: any(name != "Force: 0.00 N" for name in said("Force: ", before)))
    wait("a touch is said", lambda: said("Touch: Touching bone, ", before))

    step("stops")
    # Escape takes the force away, and says so
    before = len(heard)
    press("Escape")
    wait("it is said that Escape stopped it", lambda: said("Force stopped by Escape", before))
    wait("the state is said", lambda: said("State of the force: Force stopped", before))
    assert len(said("State of the force: Force stopped", before)) == 1, heard[before:]
    alert = said_by("Force stopped by Escape", before).get_parent()
    assert alert.get_role_name() == "alert", alert.get_role_name()

    # and is brought back by keys
    step("brings it back by keys")
    tab_to("push button", lambda part: part.get_name() == "Resume")
    before = len(heard)
    press("space")
    wait("the force is back", lambda: said("State of the force: Force shown", before))
    listener.deregister("object:state-changed:focused")


def take_keyboard():
    """Gives the keyboard to the window under the pointer, as a window manager does."""
    x11 = ctypes.CDLL("libX11.so.6")
    x11.XOpenDisplay.restype = ctypes.c_void_p
    display = ctypes.c_void_p(x11.XOpenDisplay(None))
    x11.XDefaultRootWindow.restype = ctypes.c_ulong
    root = ctypes.c_ulong(x11.XDefaultRootWindow(display))
    child, number, mask = ctypes.c_ulong(), ctypes.c_int(), ctypes.c_uint()
    x11.XQueryPointer(display, root, ctypes.byref(ctypes.c_ulong()), ctypes.byref(child), ctypes.byref(number),
                      ctypes.byref(number), ctypes.byref(number), ctypes.byref(number), ctypes.byref(mask))
    if child.value:
        x11.XSetInputFocus(display, child, 1, ctypes.c_ulong(0))
    x11.XCloseDisplay(display)
    pump()
    return focus


def find_window():
    return next((part for part in parts(program()) if part.get_role_name() == "frame" and "demo" in part.get_name()),
                None)


def german():
    wait("the surface, in German", lambda: find("canvas", "3-D-Ansicht: Oberfläche bei "))
    the("slider", "Isowert")
    wait("the state of the force, in German", lambda: find("notification", "Zustand der Kraft: Kraft"))


def run(phantom, test, home, **locale):
    known.clear()
    environment = dict(os.environ, HOME=home, XDG_CONFIG_HOME=home + "/config", XDG_DATA_HOME=home + "/data",
                       QT_LINUX_ACCESSIBILITY_ALWAYS_ON="1", **locale)
    process = subprocess.Popen([sys.argv[1], "--phantom", phantom, "--no-notice", "--surface", "mesh"],
                               env=environment)
    try:
        test()
    finally:
        process.terminate()
        code = process.wait(timeout=LONG)
    assert code == 0, code


os.environ.pop("LANGUAGE", None)
Atspi.init()
Atspi.set_timeout(1000 * LONG, 1000 * LONG)
with tempfile.TemporaryDirectory() as home:
    run("demo", main, home, LC_ALL="C.UTF-8")
    step("speaks the language of the system")
    run("sphere", german, home, LC_ALL="de_DE.UTF-8")
print("the first touch was done by keyboard, and was said")
