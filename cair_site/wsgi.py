"""The WSGI application: content is loaded here, before the workers are forked."""

import os

from django.core.wsgi import get_wsgi_application

os.environ.setdefault("DJANGO_SETTINGS_MODULE", "cair_site.settings")
application = get_wsgi_application()

from django.db import connections  # noqa: E402 - settings come first

from dialogue.publishing import preload  # noqa: E402

preload()
connections.close_all()
