"""The command cair-chat: reads its options, then chats until there is nothing more to read."""

import argparse
import logging
import os
import sys

from cair_client import CairError, Conversation, __version__

EPILOG = "Type /help in the chat for its commands. Lines from a pipe are read one after another."


def _options(arguments):
    parser = argparse.ArgumentParser("cair-chat", description=_ABOUT, epilog=EPILOG)
    address = os.environ.get("CAIR_SERVER", "http://127.0.0.1:8000")
    parser.add_argument("--server", default=address, help="address (CAIR_SERVER) [%(default)s]")
    parser.add_argument("--language", help="en, it or ja")
    parser.add_argument("--culture", help="EN, IT, JP or IN")
    parser.add_argument("--person", help="your name, which is not sent")
    parser.add_argument("--gender", choices=("f", "m"), help="for content with gender forms")
    parser.add_argument("--state", metavar="FILE", help="go on from this file, keep the talk there")
    parser.add_argument("--seed", type=int, help="the same number gives the same talk")
    parser.add_argument("--key", help="API key; better in CAIR_KEY, where others do not see it")
    parser.add_argument("--ca-file", metavar="FILE", help="certificates to trust (PEM)")
    parser.add_argument("--plain", action="store_true", help="no colours and tables")
    parser.add_argument("--version", action="version", version=__version__)
    return parser.parse_args(arguments)


_PATIENCE = 15.0  # seconds: who types is told sooner than a robot
_ABOUT = "Talk with a CAIR server; plans are shown, and what a robot would do."


def main(arguments=None):
    """Chat; return 0, or 1 where a call to the server went wrong."""
    if sys.version_info < (3, 6):
        sys.exit("cair-chat needs Python 3.6; the module cair_client does not.")
    from cair_chat.chat import Chat, explained
    from cair_chat.screens import screen, utf8_streams

    options = _options(arguments)
    logging.basicConfig(level=logging.CRITICAL)  # what went wrong is shown in the chat
    utf8_streams()
    shown = screen(options.plain)
    try:
        chat = Chat(_talk(options), shown)
        chat.begin()
        _read_on(chat, shown)
    except CairError as error:
        sys.stderr.write("cair-chat: %s\n" % explained(error))
        return 1
    except (EOFError, KeyboardInterrupt):
        shown.end()
    except BrokenPipeError:  # whoever read what we write has gone
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    return int(chat.failed)


def _read_on(chat, shown):
    while chat.hear(shown.read()):
        pass
    shown.end()


def _talk(options):
    return Conversation(
        options.server,
        language=options.language,
        culture=options.culture,
        state_file=options.state,
        person=options.person,
        gender=options.gender,
        key=options.key or os.environ.get("CAIR_KEY"),
        seed=options.seed,
        patience=_PATIENCE,
        ca_file=options.ca_file,
    )


if __name__ == "__main__":
    sys.exit(main())
