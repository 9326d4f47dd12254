"""A chat: what is typed goes to the server or is a command; plans are shown and simulated."""

import io

from cair_client import CairError, UnreachableError

HELP = (
    ("/explain", "why the last reply was said"),
    ("/state", "what the dialogue state holds"),
    ("/language it", "begin a new talk in another language; alone: what there is"),
    ("/culture JP", "begin a new talk with a person of another culture; alone: what there is"),
    ("/history", "all that was said"),
    ("/save FILE", "write all that was said into a file"),
    ("/help", "this list"),
    ("/quit", "the end; also Ctrl-D"),
)
LONGEST_TABLE = 12
NOT_SAID = "(nobody said)"
AGAIN = "Nothing is lost: say it again."


class Chat:
    """A talk on a screen.

    talk -- a Conversation. screen -- a PlainScreen or RichScreen.
    """

    def __init__(self, talk, screen):
        self._talk = talk
        self._screen = screen
        self._meanings = {}
        self._history = []  # (a key of LABELS, text)
        self._asked = None  # the turn that can be explained
        self.failed = False  # a sentence was not answered

    def begin(self):
        """Show the first sentence. Raises CairError."""
        self._learn_actions()
        self._perform(self._talk.start())

    def hear(self, line):
        """Answer a line; False where it was the wish to end."""
        line = line.strip()
        if line in ("/quit", "/exit"):
            return False
        try:
            if line.startswith("/"):
                self._command(*line.partition(" ")[::2])
            elif line:
                self._turn(line)
        except CairError as error:
            self.failed = self.failed or not line.startswith("/")
            self._note(explained(error))
            if isinstance(error, UnreachableError):
                self._note(AGAIN)
        return True

    def _learn_actions(self):
        """Take on every action there is, also those that few robots have."""
        for one in self._talk.call("GET", "actions/"):
            if not one["kb"]:
                self._meanings[one["name"]] = one["meaning"]
                self._talk.on(one["name"], self._simulate)

    def _turn(self, text):
        asked = {"client_sentence": text, "dialogue_state": self._talk.dialogue_state}
        with self._screen.waiting():
            reply = self._talk.say(text)
        self._asked = dict(asked, capabilities=self._talk.capabilities)
        self._history.append(("you", text))
        self._perform(reply)

    def _perform(self, reply):
        if reply.restarted:
            self._note("The old state could not be read: it is kept aside, the talk begins anew.")
        if reply.actions:
            self._screen.plan([self._row(action) for action in reply.actions])
        self._talk.perform(reply, self._say)

    def _say(self, text):
        self._history.append(("agent", text))
        self._screen.show("agent", text)

    def _simulate(self, action):
        _, parameters, meaning = self._row(action)
        done = "(%s) %s" % (" ".join(part for part in (action.name, parameters) if part), meaning)
        self._history.append(("robot", done))
        self._screen.show("robot", done)

    def _row(self, action):
        pairs = sorted(action.parameters.items())
        shown = ", ".join("%s: %s" % (name, text or NOT_SAID) for name, text in pairs)
        return action.name, shown, self._meanings.get(action.name, "")

    def _note(self, text):
        self._screen.show("note", text)

    def _command(self, name, rest):
        command = COMMANDS.get(name)
        if command is None:
            self._note("There is no %s; /help lists what there is." % name)
            return
        command(self, rest.strip())

    def _help(self, _):
        self._screen.table("", ("command", "what it does"), HELP)

    def _explain(self, _):
        if not self._asked:
            self._note("Nothing to explain yet: say something first.")
            return
        steps = self._talk.call("POST", "dialogue/explain/", self._asked)["steps"]
        rows = []
        for step in steps:
            rows.append((step["rule"], step["text"]))
            shown = [
                "%s %.2f" % (one["topic"], one["likeliness"]) for one in step.get("candidates", [])
            ]
            if shown:
                more = ", …" if len(shown) > LONGEST_TABLE else ""
                rows.append(("", ", ".join(shown[:LONGEST_TABLE]) + more))
        self._screen.table("Why", ("rule", "what it did"), rows)

    def _state(self, _):
        fields = {"dialogue_state": self._talk.dialogue_state}
        self._screen.table("State", ("field", "value"), list(_state_rows(self._inspect(fields))))

    def _inspect(self, fields):
        return self._talk.call("POST", "dialogue/inspect/", fields)

    def _language(self, code):
        if not code:
            found = self._talk.call("GET", "hub/options/")["languages"]
            rows = [(one["code"], one["own_name"]) for one in found]
            self._screen.table("Languages", ("code", "name"), rows)
            return
        self._begin_with(language=code, culture=None)

    def _culture(self, code):
        if not code:
            found = self._talk.call("GET", "hub/options/")["cultures"]
            rows = [(one["code"], ", ".join(one["names"].values())) for one in found]
            self._screen.table("Cultures", ("code", "name"), rows)
            return
        self._begin_with(language=self._talk.language, culture=code)

    def _begin_with(self, language, culture):
        """Begin a new talk; where the server refuses, go on with the one there is."""
        before = self._talk.language, self._talk.culture
        self._talk.language, self._talk.culture = language, culture
        try:
            reply = self._talk.start(afresh=True)
        except CairError:
            self._talk.language, self._talk.culture = before
            raise
        self._asked = None
        self._perform(reply)

    def _show_history(self, _):
        for who, text in self._history:
            self._screen.show(who, text)

    def _save(self, path):
        path = path or "talk.txt"
        try:
            with io.open(path, "x", encoding="utf-8") as file:
                for who, text in self._history:
                    file.write("%-6s %s\n" % (who + ":", text))
        except EnvironmentError as error:
            self._note("Not written: %s: %s." % (path, error.strerror))
        else:
            self._note("Written: %s" % path)


COMMANDS = {
    "/help": Chat._help,
    "/explain": Chat._explain,
    "/state": Chat._state,
    "/language": Chat._language,
    "/culture": Chat._culture,
    "/history": Chat._show_history,
    "/save": Chat._save,
}


def _state_rows(state):
    """Return what a state holds, the topics the person likes most first."""
    for name in ("language", "culture", "turn", "topic", "sentence_type", "pattern", "offer"):
        yield name, str(state[name])
    liked = sorted(state["likeliness"].items(), key=lambda pair: -pair[1])[:LONGEST_TABLE]
    yield "likeliness", ", ".join("%s %.2f" % pair for pair in liked)
    yield "recent topics", ", ".join(state["recent_topics"][:LONGEST_TABLE])
    yield "avoided", ", ".join(state["avoided"][:LONGEST_TABLE])


def explained(error):
    """Return an error for people."""
    return " ".join(part for part in (error.message, error.hint) if part)
