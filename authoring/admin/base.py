"""What all forms of the draft share."""

from typing import Any

from django.http import HttpRequest

from authoring.admin.telling import ConflictAdmin, HistoryAdmin
from dialogue import authoring


class ContentAdmin(HistoryAdmin, ConflictAdmin):
    """The form of a row that experts write."""


class PlacedAdmin(ContentAdmin):
    """The form of a row that has a place among others: a new one is proposed after all."""

    def get_changeform_initial_data(self, request: HttpRequest) -> dict[str, Any]:
        """Return what a new row begins with."""
        place = authoring.next_position(self.model)
        return {"position": place, **super().get_changeform_initial_data(request)}
