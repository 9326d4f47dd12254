"""A whole cluster on one machine: PostgreSQL, several nodes, a load balancer; and its trial.

python -m cluster          # starts it, prints the addresses, Ctrl-C ends all
python -m cluster.trial    # breaks it in every way under steady load, and counts
python -m cluster.soak     # watches memory and latency for a long time
"""
