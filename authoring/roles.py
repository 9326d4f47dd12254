"""The roles: what authors, publishers, researchers and administrators may do."""

from typing import TYPE_CHECKING

from django.apps import apps as current_apps
from django.apps.registry import Apps
from django.contrib.auth.management import create_permissions

if TYPE_CHECKING:
    from django.contrib.auth.models import Permission

AUTHOR, PUBLISHER, RESEARCHER, ADMINISTRATOR = "author", "publisher", "researcher", "administrator"

_CONTENT = ("dialogue", "plans")
_WRITE = ("view", "add", "change", "delete")
_NEVER_WRITTEN = ("publication",)
PUBLISH, EXPORT = "publish_draft", "export_content"


def write_roles(apps: Apps = current_apps, **_more: object) -> None:
    """Make the groups of the roles hold exactly their permissions; members stay."""
    group = apps.get_model("auth", "Group")
    permission = apps.get_model("auth", "Permission")
    for label in (*_CONTENT, "authoring", "auth"):
        create_permissions(current_apps.get_app_config(label), verbosity=0, apps=apps)
    rows = list(permission.objects.select_related("content_type"))
    for role in (AUTHOR, PUBLISHER, RESEARCHER, ADMINISTRATOR):
        members, _ = group.objects.get_or_create(name=role)
        members.permissions.set([row for row in rows if _may(role, row)])


def _may(role: str, row: "Permission") -> bool:
    app, model, name = row.content_type.app_label, row.content_type.model, row.codename
    if role == ADMINISTRATOR:
        return app in (*_CONTENT, "authoring", "auth", "admin")
    verb = name.partition("_")[0]
    if name in (PUBLISH, EXPORT):
        return role == PUBLISHER or name == EXPORT
    if app not in (*_CONTENT, "authoring") or model == "apikey":
        return False
    if role == RESEARCHER or model in _NEVER_WRITTEN or model.startswith("historical"):
        return verb == "view"
    return verb in _WRITE
