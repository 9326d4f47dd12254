"""Tests of the cluster: those marked `cluster` start one (make test-cluster)."""

import pytest


def pytest_configure(config: pytest.Config) -> None:
    """Make the mark known."""
    config.addinivalue_line(
        "markers", "cluster: starts PostgreSQL, nodes and HAProxy (make test-cluster)"
    )


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Keep what starts a cluster out of the quick tests, as all that starts a server is."""
    for item in items:
        if item.get_closest_marker("cluster"):
            item.add_marker(pytest.mark.server)
