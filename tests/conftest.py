"""Fixtures of the site are there only where Django is: engine tests run without it."""

import pytest


def pytest_configure(config: pytest.Config) -> None:
    """Load the fixtures of the site in runs that have pytest-django."""
    if config.pluginmanager.hasplugin("django"):
        config.pluginmanager.import_plugin("tests.site_fixtures")
