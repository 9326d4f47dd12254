"""The WSGI application: content is loaded here, before the workers are forked."""

import gc
import os

# Collections while a million values are made that stay find nothing and take a fifth of the start.
gc.disable()

from django.core.wsgi import get_wsgi_application  # noqa: E402

os.environ.setdefault("DJANGO_SETTINGS_MODULE", "cair_site.settings")
django_application = get_wsgi_application()

from django.conf import settings  # noqa: E402 - settings come first
from django.db import connections  # noqa: E402
from django.urls import get_resolver  # noqa: E402

from cair_site.chunked import Chunked  # noqa: E402
from dialogue.publishing import preload  # noqa: E402

application = Chunked(django_application, settings.CAIR_LONGEST_BODY)
preload()
# The first call of a fresh worker would else import the whole site.
_ = get_resolver().url_patterns
connections.close_all()
# Collections would write to every page of the content, and each worker get a copy of its own. The
# garbage of loading, about a megabyte, stays: looking for it would take a third of a second.
gc.freeze()
gc.enable()
