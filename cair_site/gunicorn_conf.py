"""gunicorn: content is loaded once and shared by all workers."""

wsgi_app = "cair_site.wsgi"
preload_app = True
worker_class = "gthread"
# A stalled client holds a thread, not a worker.
threads = 16
timeout = 30
graceful_timeout = 20
keepalive = 15
backlog = 2048
limit_request_line = 4094
max_requests = 0
accesslog = None
errorlog = "-"
control_socket_disable = True
