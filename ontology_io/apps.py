"""Knowledge in and out, as a Django app (its commands)."""

from django.apps import AppConfig


class OntologyIOConfig(AppConfig):
    name = "ontology_io"
    verbose_name = "Ontology in and out"
