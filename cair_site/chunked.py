"""Bodies that come in chunks, without a length: read within a limit, so that views see them."""

from collections.abc import Iterable
from io import BytesIO
from wsgiref.types import StartResponse, WSGIApplication, WSGIEnvironment

import msgspec

from cair_site.errors import ApiError, error_json
from cair_site.metrics import count_error
from cair_site.request_ids import HEADER, META, id_for


class Chunked:
    """Gives a chunked body the length that Django asks for; a longer one than allowed gets 413."""

    def __init__(self, application: WSGIApplication, longest: int) -> None:
        self.application = application
        self.longest = longest

    def __call__(self, environ: WSGIEnvironment, start_response: StartResponse) -> Iterable[bytes]:
        """Answer a request, whether its body has a length or not."""
        chunked = "chunked" in environ.get("HTTP_TRANSFER_ENCODING", "").lower()
        if not chunked or environ.get("CONTENT_LENGTH"):
            return self.application(environ, start_response)
        body = environ["wsgi.input"].read(self.longest + 1)
        if len(body) > self.longest:
            return _too_large(environ, start_response)
        environ["wsgi.input"] = BytesIO(body)
        environ["CONTENT_LENGTH"] = str(len(body))
        return self.application(environ, start_response)


def _too_large(environ: WSGIEnvironment, start_response: StartResponse) -> list[bytes]:
    count_error("body.too_large")
    body = msgspec.json.encode(error_json(ApiError("body.too_large")))
    headers = [("Content-Type", "application/json"), ("Content-Length", str(len(body)))]
    headers.append((HEADER, id_for(environ.get(META, ""))))
    start_response("413 Content Too Large", headers)
    return [body]
