"""gunicorn's own log in the form of ours: what cannot be read as HTTP is not quoted.

A robot that counts its bytes wrongly sends the rest of a sentence as the next request line.
"""

import logging
from typing import Any

from gunicorn.glogging import Logger  # type: ignore[import-untyped]

from cair_site import environment
from cair_site.log_lines import FORMATTERS

_QUOTES = "Invalid request from ip="


class ServerLog(Logger):  # type: ignore[misc]
    """The log of the server."""

    def setup(self, cfg: Any) -> None:
        """Set the handlers up with our formatter."""
        super().setup(cfg)
        form = FORMATTERS[environment.choice("CAIR_LOG_FORMAT", tuple(FORMATTERS))]()
        for handler in self.error_log.handlers:
            handler.setFormatter(form)

    def warning(self, msg: str, *args: Any, **more: Any) -> None:
        """Log a warning; of a request that is no HTTP only that there was one."""
        if msg.startswith(_QUOTES):
            super().log(logging.WARNING, "A request that is no HTTP was refused.")
        else:
            super().warning(msg, *args, **more)

    def exception(self, msg: object, *_args: Any, **_more: Any) -> None:
        """Log where something broke; not the address that was called."""
        text = msg.partition(" %")[0] if isinstance(msg, str) else "Something broke"
        super().exception("%s", text)
