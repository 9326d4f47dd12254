# -*- coding: utf-8 -*-
"""A robot's side of a talk with a CAIR server; Python 2.7 and 3.6 or newer, nothing to install.

    from cair_client import Conversation

    talk = Conversation("http://127.0.0.1:8000", language="en", state_file="talk.json")

    @talk.on("playsong")
    def play(action):
        music.play(action.parameters["title"])  # None: any song

    talk.perform(talk.start(), say=print)
    while True:
        talk.perform(talk.say(input("you: ")), say=print)

The server remembers nothing. What it must know again is in the state file, which is replaced as a
whole after each good answer: a turn that fails with a CairError can simply be said again.
"""

from __future__ import unicode_literals

import contextlib
import io
import json
import logging
import os
import random
import re
import socket
import ssl
import sys
import threading
import time
import zlib
from collections import namedtuple

try:
    from http.client import HTTPException
    from urllib.error import HTTPError
    from urllib.parse import urlencode, urlsplit
    from urllib.request import HTTPRedirectHandler, HTTPSHandler, Request, build_opener
except ImportError:  # Python 2.7
    from urllib import urlencode

    from httplib import HTTPException
    from urllib2 import HTTPError, HTTPRedirectHandler, HTTPSHandler, Request, build_opener
    from urlparse import urlsplit

__version__ = "1.0.0"
__all__ = [
    str(name) for name in ("Action", "CairError", "Conversation", "Reply", "UnreachableError")
]

LONGEST_ANSWER = 4000000  # bytes, also after inflating
LONGEST_PAUSE = 8.0  # seconds between two attempts
ANY = "*"  # a handler for all actions without one of their own
AT_ONCE = ("alert",)  # actions that do not wait until something has been said
PASSING = (429, 502, 503, 504)  # statuses worth another attempt

_log = logging.getLogger(__name__)
_now = getattr(time, "monotonic", time.time)
_sleep = time.sleep
_text = type("")


class CairError(Exception):
    """What went wrong. `code` is stable; those of the server are in docs/errors.md.

    Those of the client: client.address, client.tls, client.key, client.redirected, client.answer,
    client.answer_too_large, client.state_file, client.unreachable.
    """

    def __init__(self, code, message, hint="", status=0):
        Exception.__init__(self, code, message, hint)
        self.code = code
        self.message = message
        self.hint = hint
        self.status = status

    def __str__(self):
        shown = " ".join(part for part in (self.code + ":", self.message, self.hint) if part)
        return shown if str is _text else shown.encode("utf-8")


class UnreachableError(CairError):
    """The server was not there, or too busy, for as long as patience lasts: say the same later."""


class Action(namedtuple(str("Action"), (str("name"), str("parameters")))):
    """Something to do. `parameters` has a text for each name, None where nobody said it."""

    __slots__ = ()


_FIELDS = "plan_sentence dialogue_sentence actions plan topic sentence_type restarted"


class Reply(namedtuple(str("Reply"), [str(name) for name in _FIELDS.split()])):
    """One answer: say `plan_sentence`, do `actions` in order, say `dialogue_sentence`.

    `plan` is the actions as the server wrote them, never to be spoken. `restarted` says that the
    old state could not be read, so that this reply begins a new talk.
    """

    __slots__ = ()

    @property
    def text(self):
        """All that is to be said, for clients that do nothing between the two sentences."""
        gap = "" if self.plan_sentence.endswith(("。", "！", "？", "…")) else " "
        return gap.join(part for part in (self.plan_sentence, self.dialogue_sentence) if part)


SILENCE = Reply("", "", (), "", "", "", False)


class Conversation(object):
    """A talk with one person (or group) that goes on for as long as its state file is kept.

    language, culture -- "en", "it" or "ja"; "EN", "IT", "JP" or "IN". Left out, the state file or
        else the server decides. Others than those of the state file begin a new talk.
    state_file -- path; without it the talk ends with the program. Replaced files are kept aside.
    person, gender -- filled into what is said and never sent: a name; "f" or "m" for the `ə` that
        Italian content of your own may hold ("amicə"). May be changed at any time.
    key -- the API key, where the server wants one.
    capabilities -- names of the actions; left out, those with a handler.
    seed -- 1 to 4294967295: the same talk each time.
    timeout, patience -- seconds for one attempt; for all attempts of a turn together.
    ca_file -- certificates (PEM) to trust instead of those of the system.
    transport -- instead of HTTP: (method, url, headers, body, seconds) -> (status, headers, body).
    """

    def __init__(
        self,
        server,
        language=None,
        culture=None,
        state_file=None,
        person=None,
        gender=None,
        key=None,
        capabilities=None,
        seed=None,
        timeout=10.0,
        patience=30.0,
        ca_file=None,
        transport=None,
    ):
        self.language = _unicode(language)
        self.culture = _unicode(culture)
        self.person = person
        self.gender = gender
        self.seed = seed
        self._capabilities = None if capabilities is None else sorted(capabilities)
        self._handlers = {}
        self._lock = threading.RLock()
        self._kept = _StateFile(state_file)
        self._talk = None  # what the state file holds
        self._granted = None  # the language and culture this talk was begun for
        self._server = _Server(server, key, timeout, patience, transport or _http(server, ca_file))

    @property
    def dialogue_state(self):
        """The state after the last good answer, "" before the first."""
        return self._talk["dialogue_state"] if self._talk else ""

    @property
    def capabilities(self):
        """The actions the server may plan; None (handler for "*"): what robots usually do."""
        if self._capabilities is not None:
            return self._capabilities
        return None if ANY in self._handlers else sorted(self._handlers)

    def on(self, action, handler=None):
        """Let handler(Action) do an action; a text it returns is said. Also as a decorator.

        "*" takes all actions that have no handler of their own.
        """

        def register(function):
            self._handlers[_unicode(action)] = function
            return function

        return register if handler is None else register(handler)

    def start(self, afresh=False):
        """Return the first sentence: a welcome back where there is a state, else the beginning.

        `afresh` begins a new talk; the old state file is kept aside.
        """
        with self._lock:
            return self._turn("") if self._goes_on() and not afresh else self._begin()

    def say(self, text):
        """Return what the robot answers to what the person said; to a blank, SILENCE."""
        text = _whole(_unicode(text) or "").strip()
        if not text:
            return SILENCE
        with self._lock:
            if not self._goes_on():
                self._begin()
            return self._turn(text)

    def perform(self, reply, say):
        """Say and do a reply in its order; return the actions that were not done.

        `say(text)` should return when the text has been spoken. `alert` comes before all words. An
        action without handler is skipped; one whose handler fails is logged, and the talk goes on.
        """
        undone = self._do([one for one in reply.actions if one.name in AT_ONCE], say)
        if reply.plan_sentence:
            say(reply.plan_sentence)
        undone += self._do([one for one in reply.actions if one.name not in AT_ONCE], say)
        if reply.dialogue_sentence:
            say(reply.dialogue_sentence)
        return undone

    def call(self, method, path, fields=None):
        """Return the JSON of any other call of docs/api.md. Example of a path: "hub/options/"."""
        return self._server.call(method, path, fields)

    def _do(self, actions, say):
        undone = []
        for action in actions:
            handler = self._handlers.get(action.name) or self._handlers.get(ANY)
            if handler is None:
                undone.append(action)
                continue
            try:
                told = handler(action)
            except Exception:  # noqa: BLE001 - logged; whatever it is, the person is not left alone
                _log.exception("The action %s failed.", action.name)
                undone.append(action)
                continue
            if told and isinstance(told, (str, _text)):
                say(_unicode(told))
        return undone

    def _goes_on(self):
        """Say whether there is a state, of the language and culture that are wanted, if any are."""
        if self._talk is None:
            self._talk = self._kept.load()
        if self._talk is None:
            return False
        granted = self._granted == (self.language, self.culture)
        return granted or (self._same_language() and self._same_culture())

    def _same_language(self):
        kept = self._talk["language"]
        return _code(self.language or kept) == _code(kept)

    def _same_culture(self):
        kept = self._talk["culture"]
        return (self.culture or kept).upper() == kept.upper()

    def _begin(self):
        """Begin a talk, in the language and culture of the last one where none are wanted."""
        language, culture = self.language, self.culture
        if self._talk and self._same_language():
            language = language or self._talk["language"]
            culture = culture or self._talk["culture"]
        wanted = (("language", language), ("culture", culture), ("seed", self.seed))
        query = urlencode([(name, _text(value).encode("utf-8")) for name, value in wanted if value])
        answer = self._hub("GET", "hub/?" + query if query else "hub/")
        reply = self._reply(answer, "first_sentence", answer.get("language"))
        names = ("dialogue_state", "language", "culture")
        talk = dict((name, _text(answer.get(name) or "")) for name in names)
        damaged = self._kept.damaged
        self._kept.put_aside()
        self._kept.save(talk)
        self._talk, self._granted = talk, (self.language, self.culture)
        return reply._replace(restarted=damaged)

    def _turn(self, text):
        try:
            answer = self._answer(text)
        except CairError as error:
            if not error.code.startswith("state."):
                raise
            _log.warning("The old state is kept aside, a new talk begins: %s", error.code)
            begun = self._begin()._replace(restarted=True)
            if not text:
                return begun
            return self._advance(self._answer(text))._replace(restarted=True)
        return self._advance(answer)

    def _answer(self, text):
        fields = {"client_sentence": text, "dialogue_state": self.dialogue_state}
        if self.capabilities is not None:
            fields["capabilities"] = self.capabilities
        return self._hub("POST", "hub/", fields)

    def _hub(self, method, path, fields=None):
        answer = self._server.call(method, path, fields)
        if not isinstance(answer, dict):
            raise _odd_answer()
        return answer

    def _advance(self, answer):
        """Return the reply of a turn. The state advances here and only here, if all is well."""
        reply = self._reply(answer, "dialogue_sentence", self._talk["language"])
        self._talk = dict(self._talk, dialogue_state=answer["dialogue_state"])
        try:
            self._kept.save(self._talk)
        except CairError as error:  # A full disk must not silence a robot.
            _log.error("%s", error)
        return reply

    def _reply(self, answer, sentence, language):
        """Return an answer of the Hub, its placeholders filled."""
        texts = dict((name, answer.get(name, "")) for name in _TEXTS)
        texts["dialogue_sentence"] = answer.get(sentence)
        state = answer.get("dialogue_state")
        if not state or not all(isinstance(one, _text) for one in list(texts.values()) + [state]):
            raise _odd_answer()
        for name in ("plan_sentence", "dialogue_sentence"):
            texts[name] = _filled(texts[name], self.person, self.gender, language or "")
        return Reply(actions=_actions(answer.get("plan_actions", [])), restarted=False, **texts)


_TEXTS = [str(name) for name in ("plan_sentence", "plan", "topic", "sentence_type")]


def _actions(planned):
    """Return plan_actions as Actions."""
    try:
        return tuple(Action(one["action"], dict(one["parameters"])) for one in planned)
    except (KeyError, TypeError, ValueError):
        raise _odd_answer()


def _odd_answer():
    return CairError("client.answer", "This is no answer of a CAIR server.", "Check the address.")


# What only the client knows. Without a name, what belongs to it goes with it: "Hello, $name!" is
# "Hello!", "$nameさんは、…" is "…".

_SHOWN = r"\$(?:name|desspk|prevspk)(?![A-Za-z0-9_])"
_HONORIFIC = "(さん|様|さま|ちゃん|くん|君)"
_NAME = re.compile(_SHOWN + _HONORIFIC + "?")
_ENDS_HONOURED = re.compile(_HONORIFIC + "$")
_NAMELESS = _SHOWN + _HONORIFIC + "?"
_BETWEEN_COMMAS = re.compile(r"[,、，]\s*" + _NAMELESS + r"\s*(?=[,、，])", re.UNICODE)
_SUBJECT = re.compile(
    r"(^|[。！？!?、，]\s*)" + _NAMELESS + "(?:に?は|も|の|が)[,、，]?", re.UNICODE
)
_FIRST = re.compile(
    r"(^|[.!?…。！？]\s*)" + _NAMELESS + r"\s*[,、，!！]?\s*([^\W\d_]?)", re.UNICODE
)
_ANYWHERE = re.compile(r"\s*[,、，]?\s*" + _NAMELESS, re.UNICODE)


def _filled(text, person, gender, language):
    """Return a sentence with the person's name, or without its place."""
    ending = {"f": "a", "m": "o"}.get(gender)
    if ending and _code(language) == "it":
        text = text.replace("ə", ending)
    if "$" not in text:
        return text
    name = " ".join(_unicode(person or "").split())
    return _NAME.sub(lambda found: _honoured(name, found), text) if name else _nameless(text)


def _honoured(name, found):
    """Return the name with the honorific of the sentence, unless it has one of its own."""
    return name if _ENDS_HONOURED.search(name) else name + (found.group(1) or "")


def _nameless(text):
    text = _BETWEEN_COMMAS.sub("", text)
    text = _SUBJECT.sub(lambda found: found.group(1), text)
    text = _FIRST.sub(lambda found: found.group(1) + found.group(3).upper(), text)
    return re.sub(" {2,}", " ", _ANYWHERE.sub("", text)).strip()


class _StateFile(object):
    """A file that is there as a whole, old or new, whatever happens."""

    def __init__(self, path):
        self._path = os.path.realpath(os.path.expanduser(path)) if path else None
        self.damaged = False

    def load(self):
        """Return what was saved, or None; says `damaged` where a file is there but is no talk."""
        if not self._path or not os.path.exists(self._path):
            return None
        with self._trouble(), io.open(self._path, "rb") as file:
            data = file.read(LONGEST_ANSWER)
        try:
            talk = json.loads(data.decode("utf-8"))
            names = ("dialogue_state", "language", "culture")
            talk = dict((name, talk[name]) for name in names)
        except (ValueError, TypeError, LookupError):
            talk = {"dialogue_state": ""}
        self.damaged = not (talk["dialogue_state"] and all(map(_is_text, talk.values())))
        return None if self.damaged else talk

    def save(self, talk):
        """Replace the file."""
        if not self._path:
            return
        data = json.dumps(talk, sort_keys=True, indent=1).encode("ascii")
        with self._trouble():
            folder = os.path.dirname(self._path)
            if not os.path.isdir(folder):
                os.makedirs(folder)
            new = self._path + ".new"
            flags = os.O_WRONLY | os.O_CREAT | os.O_TRUNC | getattr(os, "O_BINARY", 0)
            with os.fdopen(os.open(new, flags, 0o600), "wb") as file:
                file.write(data)
                file.flush()
                os.fsync(file.fileno())
            _replace(new, self._path)
            _sync_folder(folder)

    def put_aside(self):
        """Rename the file, if there is one, so that a new talk does not cost the old one."""
        self.damaged = False
        if not self._path or not os.path.exists(self._path):
            return
        stem = self._path + time.strftime(str(".aside-%Y%m%d-%H%M%S"))
        aside, number = stem, 1
        while os.path.exists(aside):
            number += 1
            aside = "%s-%d" % (stem, number)
        with self._trouble():
            os.rename(self._path, aside)

    @contextlib.contextmanager
    def _trouble(self):
        try:
            yield
        except EnvironmentError as error:
            message = "The state file %s: %s." % (self._path, error.strerror or error)
            raise CairError("client.state_file", message, "Name one that can be written.")


def _replace(new, old):
    if hasattr(os, "replace"):
        os.replace(new, old)
    elif os.name != "nt":
        os.rename(new, old)
    else:  # Python 2.7 on Windows cannot rename onto a file.
        import ctypes

        replace_and_write_through = 0x1 | 0x8
        if not ctypes.windll.kernel32.MoveFileExW(
            _text(new), _text(old), replace_and_write_through
        ):
            raise ctypes.WinError()


def _sync_folder(folder):
    if os.name == "nt":
        return
    opened = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(opened)
    except EnvironmentError:  # Some file systems cannot; the rename is still whole.
        pass
    finally:
        os.close(opened)


class _Server(object):
    """Calls of the API: zlib JSON out, JSON in, again and again while there is hope."""

    def __init__(self, address, key, timeout, patience, transport):
        self._base = _base(address)
        self._timeout = timeout
        self._patience = patience
        self._transport = transport
        self._headers = {
            "Accept": "application/json",
            "Content-Type": "application/json",
            "Content-Encoding": "deflate",
            "User-Agent": "cair-client/%s Python/%d.%d" % ((__version__,) + sys.version_info[:2]),
        }
        if key:
            self._headers["X-Api-Key"] = _checked_key(_unicode(key))

    def call(self, method, path, fields=None):
        """Return the answer. Raises CairError; UnreachableError when patience is at an end."""
        body = None if fields is None else zlib.compress(json.dumps(fields).encode("ascii"))
        headers = self._headers
        if body is None:
            headers = dict(one for one in headers.items() if not one[0].startswith("Content-"))
        until = _now() + self._patience
        attempt = 0
        while True:
            seconds = max(0.1, min(self._timeout, until - _now()))
            answer, trouble, pause = self._attempt(method, path, headers, body, seconds)
            if trouble is None:
                return answer
            attempt += 1
            if pause is None:
                pause = min(LONGEST_PAUSE, 0.25 * 2 ** min(attempt, 9))
                pause *= random.uniform(0.5, 1.0)  # so that many robots do not come back at once
            if _now() + pause >= until:
                raise trouble
            _sleep(pause)

    def _attempt(self, method, path, headers, body, seconds):
        """Return (answer, None, None), or (None, why not, how long to wait) if it may pass."""
        try:
            status, headers, data = self._transport(
                method, self._base + path, headers, body, seconds
            )
            answer = _read_json(data) if status < 300 or status >= 400 else None
        except (EnvironmentError, HTTPException, zlib.error, EOFError) as error:
            message = "No answer from %s: %s." % (self._base, _reason(error))
            hint = "Is the server running, and the network there?"
            return None, UnreachableError("client.unreachable", message, hint), None
        if status in PASSING:
            trouble = _refusal(status, answer, UnreachableError)
            return None, trouble, _pause(headers.get("retry-after"))
        if 300 <= status < 400:
            message = "The server sends elsewhere: %s" % headers.get("location", "")
            raise CairError("client.redirected", message, "Use that address.", status)
        if status >= 400:
            raise _refusal(status, answer, CairError)
        if not isinstance(answer, (dict, list)):
            raise _odd_answer()
        return answer, None, None


def _base(address):
    """Return the address of the API, of a server with or without /api/v1."""
    address = _unicode(address or "").strip().rstrip("/")
    try:
        parts = urlsplit(address)
        usable = parts.scheme in ("http", "https") and parts.hostname and parts.port != 0
    except ValueError:
        usable = False
    if not usable or re.search(r"[\x00-\x20?#@\x7f-\uffff]", address):
        message = "This is no address of a server: %s" % address
        raise CairError("client.address", message, "Example: https://cair.example:8000")
    return re.sub("/api/v1$", "", address) + "/api/v1/"


def _checked_key(key):
    key = key.strip()
    if not re.match("[!-~]+$", key):
        raise CairError("client.key", "The API key has letters no key has.", "Copy it again.")
    return key


def _pause(retry_after):
    """Return the seconds a server asks to wait; None where it names none."""
    return float(retry_after) if re.match("[0-9]{1,9}$", retry_after or "") else None


def _reason(error):
    reason = getattr(error, "reason", None) or error
    try:
        return _text(reason) or type(error).__name__
    except UnicodeError:  # Python 2.7: a message in the letters of the system
        return type(error).__name__


def _refusal(status, answer, kind):
    """Return the error in an answer; one of our own where a proxy answered."""
    error = answer.get("error") if isinstance(answer, dict) else None
    if not isinstance(error, dict):
        return kind("http.%d" % status, "The server answered %d." % status, "", status)
    code, message, hint = (_text(error.get(name, "")) for name in ("code", "message", "hint"))
    return kind(code, message, hint, status)


def _read_json(data):
    """Return a body as JSON, None where it is none; zlib.error where it is cut off."""
    if data[:1] == b"x" or data[:2] == b"\x1f\x8b":
        inflate = zlib.decompressobj(47)  # zlib or gzip
        data = inflate.decompress(data, LONGEST_ANSWER)
        if inflate.unconsumed_tail:
            raise _too_large()
    try:
        return json.loads(data.decode("utf-8"))
    except ValueError:
        return None


def _too_large():
    message = "The answer has more than %d bytes." % LONGEST_ANSWER
    return CairError("client.answer_too_large", message, "Check the address.")


class _NoRedirects(HTTPRedirectHandler):
    """A redirect would turn a POST into a GET and hand the key to others."""

    def redirect_request(self, *_):
        """Refuse."""


def _http(server, ca_file):
    """Return the transport that is used where none is given: urllib, TLS always verified."""
    opener = build_opener(_NoRedirects(), *_tls(server, ca_file))

    def transport(method, url, headers, body, seconds):
        until = _now() + seconds
        # Python 2.7 joins headers and body: all must be bytes.
        named = dict((str(name), str(value)) for name, value in headers.items())
        try:
            response = opener.open(Request(str(url), body, named), timeout=seconds)
        except HTTPError as error:
            response = error
        except (EnvironmentError, _Untrusted) as error:
            _refuse_untrusted(error)
            raise
        with contextlib.closing(response):
            got = dict((name.lower(), _unicode(value)) for name, value in response.info().items())
            return response.code, got, _read(response, got.get("content-length"), until)

    return transport


#: Python 2.7.8 and older know no such error: they refuse TLS before.
_Untrusted = getattr(ssl, "CertificateError", ssl.SSLError)


def _tls(server, ca_file):
    if hasattr(ssl, "create_default_context"):
        try:
            return [HTTPSHandler(context=ssl.create_default_context(cafile=ca_file))]
        except EnvironmentError as error:
            message = "The certificates in %s: %s." % (ca_file, error)
            raise CairError("client.tls", message, "Name a PEM file.")
    if _unicode(server or "").strip().lower().startswith("https:"):
        message = "This Python cannot verify certificates: 2.7.9 is the first that can."
        raise CairError("client.tls", message, "Use a proxy on the robot that can.")
    return []


def _refuse_untrusted(error):
    shown = _reason(error)
    untrusted = isinstance(getattr(error, "reason", error), _Untrusted)
    if "CERTIFICATE_VERIFY_FAILED" in shown or (untrusted and _Untrusted is not ssl.SSLError):
        message = "The server's certificate is not trusted: %s." % shown
        raise CairError("client.tls", message, "Give the certificate of its authority as ca_file.")


def _read(response, length, until):
    """Return the whole body, not more than there may be and not later than allowed."""
    read = getattr(response, "read1", response.read)
    data = b""
    while True:
        piece = read(16384)
        data += piece
        if len(data) > LONGEST_ANSWER:
            raise _too_large()
        if not piece:
            break
        if _now() > until:
            raise socket.timeout("The answer comes too slowly.")
    if length and len(data) < int(length):
        raise EOFError("The answer was cut off.")
    return data


def _code(language):
    """Return the language of a tag: "it-IT" is "it"."""
    return language.replace("_", "-").split("-")[0].lower()


def _is_text(value):
    return isinstance(value, _text)


def _unicode(text):
    """Return text; Python 2.7 hands in bytes as well."""
    return text.decode("utf-8", "replace") if isinstance(text, bytes) else text


def _whole(text):
    """Return text without the halves of letters that broken input leaves: no server reads them."""
    return text.encode("utf-16", "surrogatepass").decode("utf-16", "replace")
