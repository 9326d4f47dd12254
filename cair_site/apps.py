"""The site itself as an app: its start-up checks."""

from django.apps import AppConfig


class SiteConfig(AppConfig):
    name = "cair_site"

    def ready(self) -> None:
        """Register the start-up checks."""
        from cair_site import checks  # noqa: F401 - registering needs loaded apps
