#!/usr/bin/python3
"""A portal that shows no dialog: mock_portal.py MODE, on the session's bus. Says "ready" once it is there.

MODE: choose (answers with a file), cancel, refuse (has no dialogs), old (names the request's object itself).
What it was asked goes to standard error.
"""
import sys

import dbus
import dbus.mainloop.glib
import dbus.service
from gi.repository import GLib

MODE = sys.argv[1]


class Refused(dbus.DBusException):
    _dbus_error_name = "org.freedesktop.DBus.Error.UnknownMethod"


class Request(dbus.service.Object):
    @dbus.service.signal("org.freedesktop.portal.Request", signature="ua{sv}")
    def Response(self, code, results):
        pass


class Portal(dbus.service.Object):
    def answer(self, sender, options, *uris):
        if MODE == "refuse":
            raise Refused("no dialogs here")
        token = "mine" if MODE == "old" else options["handle_token"]
        path = "/org/freedesktop/portal/desktop/request/" + sender[1:].replace(".", "_") + "/" + token
        request = Request(bus, path)
        results = {"uris": dbus.Array(uris, signature="s")}
        code, results = (1, {}) if MODE == "cancel" else (0, results)
        # At once, but for portals whose path is not known before: they take a while.
        GLib.timeout_add(300 if MODE == "old" else 0,
                         lambda: request.Response(dbus.UInt32(code), dbus.Dictionary(results, signature="sv")))
        return dbus.ObjectPath(path)

    @dbus.service.method("org.freedesktop.portal.FileChooser", "ssa{sv}", "o", sender_keyword="sender")
    def OpenFile(self, parent, title, options, sender):
        several = ["file:///tmp/another.cif"] if options.get("multiple") else []
        return self.answer(sender, options, "file:///tmp/two%20words%20%C3%A9.pdb", *several)

    @dbus.service.method("org.freedesktop.portal.FileChooser", "ssa{sv}", "o", sender_keyword="sender")
    def SaveFile(self, parent, title, options, sender):
        folder = bytes(options["current_folder"]).rstrip(b"\0").decode()
        return self.answer(sender, options, "file://" + folder + "/chosen " + options["current_name"])


dbus.mainloop.glib.DBusGMainLoop(set_as_default=True)
bus = dbus.SessionBus()
name = dbus.service.BusName("org.freedesktop.portal.Desktop", bus)
portal = Portal(bus, "/org/freedesktop/portal/desktop")
print("ready", flush=True)
GLib.MainLoop().run()
