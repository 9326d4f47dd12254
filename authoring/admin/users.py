"""The users and their roles, told in plain words."""

from typing import Any

from django import forms
from django.contrib import admin
from django.contrib.auth.admin import UserAdmin
from django.contrib.auth.forms import UserChangeForm
from django.contrib.auth.models import Group, User
from django.http import HttpRequest
from django.utils.translation import gettext_lazy as _

from authoring.roles import ADMINISTRATOR, AUTHOR, PUBLISHER, RESEARCHER

ROLES = {
    AUTHOR: _("author: writes topics, sentences and intents, and tries them out"),
    PUBLISHER: _("publisher: writes too, publishes the draft and goes back to a release"),
    RESEARCHER: _("researcher: reads everything and takes content out, changes nothing"),
    ADMINISTRATOR: _("administrator: does everything, and manages people and API keys"),
}


class _Roles(forms.ModelMultipleChoiceField):
    def label_from_instance(self, group: Group) -> str:
        """Return a role with what it may do."""
        return str(ROLES.get(group.name, group.name))


class PersonForm(UserChangeForm):
    """A user with roles to tick."""

    groups = _Roles(
        Group.objects.order_by("name"),
        required=False,
        label=_("Roles"),
        widget=forms.CheckboxSelectMultiple,
        help_text=_("Tick what the person does. Several roles add up; none means no access."),
    )


#: What makes a person mightier than any role; only a superuser gives it.
BEYOND_ROLES = ("is_superuser", "user_permissions")

admin.site.unregister(User)


@admin.register(User)
class PersonAdmin(UserAdmin):
    form = PersonForm

    class Media:
        css = {"all": ("authoring/users.css",)}

    list_display = ("username", "first_name", "last_name", "roles", "is_active")
    fieldsets = (
        (None, {"fields": ("username", "password")}),
        (_("Person"), {"fields": ("first_name", "last_name", "email")}),
        (
            _("What the person may do"),
            {
                "fields": ("is_active", "is_staff", "groups"),
                "description": _(
                    "To log in here, a person must be active and staff, and have a role."
                ),
            },
        ),
        (_("Beyond roles"), {"classes": ("collapse",), "fields": BEYOND_ROLES}),
        (_("Dates"), {"fields": ("last_login", "date_joined")}),
    )

    def get_queryset(self, request: HttpRequest) -> Any:
        return super().get_queryset(request).prefetch_related("groups")

    @admin.display(description=_("roles"))
    def roles(self, user: User) -> str:
        named = sorted(group.name for group in user.groups.all())
        return ", ".join(["superuser", *named] if user.is_superuser else named)

    def get_readonly_fields(self, request: HttpRequest, obj: Any = None) -> Any:
        dates = ("last_login", "date_joined")
        return dates if request.user.is_superuser else (*dates, *BEYOND_ROLES)

    def has_change_permission(self, request: HttpRequest, obj: Any = None) -> bool:
        return super().has_change_permission(request, obj) and _below(request, obj)

    def has_delete_permission(self, request: HttpRequest, obj: Any = None) -> bool:
        return super().has_delete_permission(request, obj) and _below(request, obj)


def _below(request: HttpRequest, user: Any) -> bool:
    """Say whether a person may touch a user: nobody but a superuser touches a superuser."""
    return user is None or not user.is_superuser or bool(request.user.is_superuser)
