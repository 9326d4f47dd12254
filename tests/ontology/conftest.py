"""The draft that the tests of this folder write."""

from hypothesis import HealthCheck, settings

from tests.ontology.drafts import empty_draft, small_draft, small_folder

__all__ = ["empty_draft", "small_draft", "small_folder"]

# A busy machine is no reason to fail.
settings.register_profile("patient", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("patient")
