# -*- coding: utf-8 -*-
"""NAOqi's services by name; one that is missing or fails is UnableError, and nothing worse."""

from __future__ import unicode_literals

import logging

_log = logging.getLogger(__name__)
_text = type("")


class UnableError(Exception):
    """The robot cannot do this now. The text is for the log."""


class Services(object):
    """What a qi session offers.

    session -- a connected qi.Session, or whatever has its `service(name)`.
    """

    def __init__(self, session):
        self._session = session
        self._subscribers = []  # NAOqi forgets a subscriber that nobody keeps

    def has(self, name):
        """Say whether the robot has this service."""
        try:
            self._session.service(str(name))
        except Exception:  # noqa: BLE001 - qi raises RuntimeError, other sessions what they like
            return False
        return True

    def call(self, name, method, *arguments):
        """Return what the method returns, when it has ended. Raises UnableError."""
        try:
            service = self._session.service(str(name))
            return _heard(getattr(service, str(method))(*[native(one) for one in arguments]))
        except Exception as error:  # noqa: BLE001 - a service may raise anything
            raise UnableError("%s.%s: %s" % (name, method, _reason(error)))

    def quietly(self, name, method, *arguments):
        """Do the same where it does not matter much; None where it cannot be done."""
        try:
            return self.call(name, method, *arguments)
        except UnableError as unable:
            _log.info("Done without: %s", unable)
            return None

    def listen(self, event, callback):
        """Let callback(value) know of an event of ALMemory; returns what ends it.

        It is called on a thread of NAOqi's. Raises UnableError.
        """
        subscriber = self.call("ALMemory", "subscriber", event)
        signal = subscriber.signal

        def told(value):
            try:
                callback(_heard(value))
            except Exception:  # noqa: BLE001 - logged; NAOqi's thread must go on
                _log.exception("The event %s was not understood.", event)

        number = signal.connect(told)
        self._subscribers.append(subscriber)
        return lambda: signal.disconnect(number)

    def on_signal(self, name, signal, callback):
        """Let callback() know of a service's signal; returns what ends it. Raises UnableError."""
        try:
            found = getattr(self._session.service(str(name)), str(signal))
            number = found.connect(lambda *_: callback())
        except Exception as error:  # noqa: BLE001 - a service may raise anything
            raise UnableError("%s.%s: %s" % (name, signal, _reason(error)))
        return lambda: found.disconnect(number)


def native(value):
    """Return a value as NAOqi's Python takes it: bytes for text on Python 2.7."""
    if isinstance(value, _text):
        return value if str is _text else value.encode("utf-8")
    if isinstance(value, dict):
        return dict((native(name), native(one)) for name, one in value.items())
    if isinstance(value, (list, tuple)):
        return [native(one) for one in value]
    return value


def _heard(value):
    """Return a value of NAOqi's with text as text."""
    if isinstance(value, bytes):
        return value.decode("utf-8", "replace")
    if isinstance(value, (list, tuple)):
        return [_heard(one) for one in value]
    return value


def _reason(error):
    try:
        return _text(error)
    except UnicodeError:  # Python 2.7: a message in bytes
        return repr(error)
