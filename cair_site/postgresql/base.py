"""JSON keeps the order of its keys, and dead connections of the pool go all at once."""

from collections.abc import Mapping
from typing import Any

from django.db.backends.base.operations import BaseDatabaseOperations
from django.db.backends.postgresql import base, operations
from psycopg import Connection, OperationalError
from psycopg_pool import ConnectionPool


class DatabaseOperations(operations.DatabaseOperations):
    """Writes JSON as the text it is."""

    def adapt_json_value(self, value: Any, encoder: Any) -> Any:
        """Return the text to store."""
        return BaseDatabaseOperations.adapt_json_value(self, value, encoder)


class DatabaseWrapper(base.DatabaseWrapper):
    """PostgreSQL as the site uses it.

    JSON is text, as it is on SQLite: jsonb would put keys into an order of its own, and then the
    same draft would no longer give the same publication. So no query looks into JSON.
    """

    data_types = {**base.DatabaseWrapper.data_types, "JSONField": "text"}
    ops_class = DatabaseOperations

    def get_new_connection(self, conn_params: Mapping[str, Any]) -> Any:
        """Return a connection that lives.

        Where the pool gives a dead one, all that it keeps are let go: else requests after a restart
        of the database would meet the dead ones one by one, each after a longer pause.
        """
        connection = super().get_new_connection(conn_params)
        if self.pool is None or _lives(connection):
            return connection
        self.pool.drain()
        self.pool.putconn(connection)
        return super().get_new_connection(conn_params)


def _lives(connection: Connection[Any]) -> bool:
    try:
        ConnectionPool.check_connection(connection)
    except OperationalError:
        return False
    return True
