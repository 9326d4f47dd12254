"""The private PostgreSQL of tests: `python -m tests.postgres COMMAND…` runs a command on one."""

import sys

from cluster.postgres import NoPostgresError as NoPostgresError
from cluster.postgres import Postgres as Postgres
from cluster.postgres import main
from cluster.postgres import private_postgres as private_postgres

if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
