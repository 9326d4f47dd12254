"""What the forms of the draft share: their history, and word of what others saved meanwhile."""

from collections.abc import Iterable
from typing import Any

from django import forms
from django.contrib import admin
from django.contrib.admin.utils import unquote
from django.core.exceptions import PermissionDenied
from django.db import connections, router, transaction
from django.db.models import Model
from django.forms.models import _get_foreign_key
from django.http import HttpRequest, HttpResponse, QueryDict
from django.shortcuts import redirect
from django.template.response import TemplateResponse
from django.utils.translation import gettext as _

from authoring.history import conflicts
from authoring.history.history import changes, history_of
from authoring.pages.changes import shown_changes


class HistoryAdmin(admin.ModelAdmin):
    """The page "History" of a row shows it and its parts together."""

    def history_view(
        self, request: HttpRequest, object_id: str, extra_context: dict[str, Any] | None = None
    ) -> HttpResponse:
        """Show who changed the row and its parts, what, and when."""
        if not self.has_view_or_change_permission(request):
            raise PermissionDenied
        row = self.get_object(request, unquote(object_id))
        if row is None:
            return redirect("admin:index")
        if not self.has_view_or_change_permission(request, row):
            raise PermissionDenied
        context = {
            **self.admin_site.each_context(request),
            **shown_changes(request, history_of(row)),
            "title": _("History of %(row)s") % {"row": row},
            "row": row,
            "opts": self.opts,
            **(extra_context or {}),
        }
        return TemplateResponse(request, "authoring/history.html", context)


class ConflictAdmin(admin.ModelAdmin):
    """Nobody overwrites unknowingly what somebody else has saved since the form was opened.

    A POST without the digest comes from no form of ours and is taken as it is.
    """

    def render_change_form(
        self, request: HttpRequest, context: dict[str, Any], *args: Any, **kwargs: Any
    ) -> HttpResponse:
        """Show the form with the digest of what it shows."""
        row = kwargs.get("obj")
        if row is not None:
            seen = request.POST.get(conflicts.SEEN) or self._shown_digest(context, row)
            form = context["adminform"].form
            hidden = forms.CharField(required=False, widget=forms.HiddenInput, initial=seen)
            form.fields[conflicts.SEEN] = hidden
            context["draft_seen"] = seen
        return super().render_change_form(request, context, *args, **kwargs)

    def changeform_view(
        self,
        request: HttpRequest,
        object_id: str | None = None,
        form_url: str = "",
        extra_context: dict[str, Any] | None = None,
    ) -> HttpResponse:
        """Save the form unless somebody else was quicker; then show both texts."""
        asked = request.method == "POST" and object_id is not None
        if not asked or conflicts.SEEN not in request.POST or "_saveasnew" in request.POST:
            return super().changeform_view(request, object_id, form_url, extra_context)
        with transaction.atomic(using=router.db_for_write(self.model)):
            told = self._told_of_conflict(request, str(object_id))
            return told or super().changeform_view(request, object_id, form_url, extra_context)

    def _told_of_conflict(self, request: HttpRequest, object_id: str) -> HttpResponse | None:
        self._lock(object_id)
        row = self.get_object(request, unquote(object_id))
        if row is None:
            return self._told_gone(request) if self.has_change_permission(request) else None
        if not self.has_change_permission(request, row):
            return None
        now = self._stored_digest(request, row)
        if now == request.POST[conflicts.SEEN]:
            return None
        return self._told_both(request, row, now)

    def _lock(self, object_id: str) -> None:
        """Let others who save this row wait; SQLite lets all writers wait anyway."""
        using = router.db_for_write(self.model)
        if connections[using].features.has_select_for_update and object_id.isdecimal():
            rows = self.model._default_manager.using(using).filter(pk=object_id)
            list(rows.select_for_update().values_list("pk"))

    def _told_gone(self, request: HttpRequest) -> HttpResponse:
        context = {
            **self.admin_site.each_context(request),
            "title": _("It was deleted while you wrote"),
            "texts": list(conflicts.written(request.POST)),
            "opts": self.opts,
        }
        return TemplateResponse(request, "authoring/conflict_gone.html", context, status=409)

    def _told_both(self, request: HttpRequest, row: Any, now: str) -> HttpResponse:
        data: QueryDict = request.POST
        for prefix, inline in self._prefixes(request, row):
            there = {str(part.pk) for part in self._parts_of(request, inline, row)}
            data = conflicts.rebased(data, prefix, there, inline.model._meta.pk.name)
        context = {
            **self.admin_site.each_context(request),
            "title": _("Somebody else has changed %(row)s meanwhile") % {"row": row},
            "differences": self._differences(request, row, data),
            "last": next(iter(changes(history_of(row), 0, 1)), None),
            "again": list(conflicts.sent_again(data)),
            "draft_seen": now,
            "row": row,
            "opts": self.opts,
        }
        return TemplateResponse(request, "authoring/conflict.html", context, status=409)

    def _differences(self, request: HttpRequest, row: Any, data: Any) -> list[Any]:
        form = self.get_form(request, row, change=True)(data, request.FILES, instance=row)
        form.is_valid()
        found = list(conflicts.form_differences(form))
        fresh = self.get_object(request, str(row.pk))  # Validating has filled the other one in.
        sets = zip(
            self._prefixes(request, fresh),
            self.get_formsets_with_inlines(request, fresh),
            strict=True,
        )
        for (prefix, inline), (formset, _inline) in sets:
            rows = inline.get_queryset(request)
            posted = formset(data, request.FILES, instance=fresh, prefix=prefix, queryset=rows)
            found += conflicts.formset_differences(posted)
        return found

    def _prefixes(self, request: HttpRequest, row: Any) -> list[tuple[str, Any]]:
        """Return the inlines with the prefixes that the admin gives their forms."""
        found: list[tuple[str, Any]] = []
        times: dict[str, int] = {}
        for formset, inline in self.get_formsets_with_inlines(request, row):
            prefix = formset.get_default_prefix()
            times[prefix] = times.get(prefix, 0) + 1
            found.append((f"{prefix}-{times[prefix]}" if times[prefix] > 1 else prefix, inline))
        return found

    def _parts_of(self, request: HttpRequest, inline: Any, row: Any) -> list[Model]:
        key = _get_foreign_key(self.model, inline.model, fk_name=inline.fk_name)
        return list(inline.get_queryset(request).filter(**{key.name: row}))

    def _stored_digest(self, request: HttpRequest, row: Any) -> str:
        """Return the digest of what the database says."""
        inlines = self.get_inline_instances(request, row)
        parts = (part for inline in inlines for part in self._parts_of(request, inline, row))
        sets = {field.name: _stored(row, field.name) for field in row._meta.local_many_to_many}
        return conflicts.digest(row, sets, parts)

    def _shown_digest(self, context: dict[str, Any], row: Any) -> str:
        """Return the digest of what a form that was just opened shows; without queries."""
        begin = context["adminform"].form.initial
        sets = {
            field.name: [one.pk for one in begin[field.name]]
            if field.name in begin
            else _stored(row, field.name)
            for field in row._meta.local_many_to_many
        }
        formsets = (each.formset for each in context["inline_admin_formsets"])
        parts = (part for formset in formsets for part in formset.get_queryset())
        return conflicts.digest(row, sets, parts)


def _stored(row: Any, name: str) -> Iterable[int]:
    return list(getattr(row, name).values_list("pk", flat=True))
