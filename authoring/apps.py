"""The app, and the Django admin with our own site in the place of the stock one."""

from django.apps import AppConfig
from django.contrib.admin.apps import AdminConfig
from django.db.models.signals import post_migrate
from django.utils.translation import gettext_lazy as _


class AuthoringConfig(AppConfig):
    name = "authoring"
    verbose_name = _("authoring")

    def ready(self) -> None:
        """Keep the groups of roles in step with the permissions there are."""
        from authoring.roles import write_roles

        post_migrate.connect(write_roles, dispatch_uid="authoring.roles")


class CairAdminConfig(AdminConfig):
    default_site = "authoring.site.CairAdminSite"

    def ready(self) -> None:
        """Name rows and fields before the forms are made of them."""
        from authoring.model_words import name_rows

        name_rows()
        super().ready()
