"""The site itself as an app: its start-up checks."""

from django.apps import AppConfig


class SiteConfig(AppConfig):
    name = "cair_site"

    def ready(self) -> None:
        """Register the start-up checks, count logins."""
        from authoring.login_throttle import tried
        from cair_site import checks  # noqa: F401 - registering needs loaded apps

        tried.connect(_count, dispatch_uid="cair_site.logins")


def _count(sender: object, result: str, **_more: object) -> None:
    from cair_site.metrics import count_login  # needs loaded apps

    count_login(result)
