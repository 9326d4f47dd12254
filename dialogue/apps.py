"""The Dialogue Manager as a Django app."""

from django.apps import AppConfig


class DialogueConfig(AppConfig):
    name = "dialogue"
    verbose_name = "Dialogue"

    def ready(self) -> None:
        """Tell the Plan Manager where its catalogue is, and count the changes of the draft."""
        from dialogue.draft import watch_changes
        from dialogue.publishing import current
        from plans.serving import serve_from

        serve_from(lambda: current().catalogue)
        watch_changes()
