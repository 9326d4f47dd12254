"""Settings of the site, all from the environment (docs/settings.md lists every variable)."""

from pathlib import Path

from cair_site import databases, environment, log_lines

BASE_DIR = Path(__file__).resolve().parent.parent
VAR = Path(environment.text("CAIR_VAR", str(BASE_DIR / "var"))).resolve()

DEBUG = environment.flag("CAIR_DEBUG")
# What an older key signed (sessions, forms) still holds: put the newest first.
SECRET_KEY, *SECRET_KEY_FALLBACKS = environment.words("CAIR_SECRET_KEYS") or [
    environment.secret("CAIR_SECRET_KEY", VAR)
]
# States signed with an older key are still read: put the newest first.
CAIR_STATE_KEYS = environment.words("CAIR_STATE_KEYS") or [
    environment.secret("CAIR_STATE_KEY", VAR)
]
ALLOWED_HOSTS = environment.words("CAIR_HOSTS", "localhost,127.0.0.1,[::1],testserver")
CSRF_TRUSTED_ORIGINS = environment.words("CAIR_ORIGINS")

INSTALLED_APPS = [
    "authoring.apps.CairAdminConfig",
    "django.contrib.auth",
    "django.contrib.contenttypes",
    "django.contrib.sessions",
    "django.contrib.messages",
    "whitenoise.runserver_nostatic",
    "django.contrib.staticfiles",
    "rest_framework",
    "drf_spectacular",
    "drf_spectacular_sidecar",
    "import_export",
    "simple_history",
    "plans.apps.PlansConfig",
    "dialogue.apps.DialogueConfig",
    "ontology_io.apps.OntologyIOConfig",
    "authoring.apps.AuthoringConfig",
    "cair_site.apps.SiteConfig",
]
MIDDLEWARE = [
    "cair_site.observing.Observed",
    "cair_site.operations.Operations",
    "cair_site.middleware.SecurityHeaders",
    "cair_site.middleware.ApiSlash",
    "cair_site.api_keys.ApiKeys",
    "cair_site.api_path.ApiPath",
    "django.middleware.security.SecurityMiddleware",
    "whitenoise.middleware.WhiteNoiseMiddleware",
    "django.contrib.sessions.middleware.SessionMiddleware",
    "django.middleware.locale.LocaleMiddleware",
    "django.middleware.common.CommonMiddleware",
    "django.middleware.csrf.CsrfViewMiddleware",
    "django.contrib.auth.middleware.AuthenticationMiddleware",
    "authoring.middleware.Recording",
    "django.contrib.messages.middleware.MessageMiddleware",
    "django.middleware.clickjacking.XFrameOptionsMiddleware",
]
ROOT_URLCONF = "cair_site.urls"
WSGI_APPLICATION = "cair_site.wsgi.application"
TEMPLATES = [
    {
        "BACKEND": "django.template.backends.django.DjangoTemplates",
        "DIRS": [BASE_DIR / "templates"],
        "APP_DIRS": True,
        "OPTIONS": {
            "context_processors": [
                "django.template.context_processors.request",
                "django.contrib.auth.context_processors.auth",
                "django.contrib.messages.context_processors.messages",
            ]
        },
    }
]
DATABASES = {"default": databases.database(environment.text("DATABASE_URL"), VAR / "cair.sqlite3")}
DEFAULT_AUTO_FIELD = "django.db.models.AutoField"
AUTH_PASSWORD_VALIDATORS = [
    {"NAME": f"django.contrib.auth.password_validation.{name}"}
    for name in (
        "UserAttributeSimilarityValidator",
        "MinimumLengthValidator",
        "CommonPasswordValidator",
        "NumericPasswordValidator",
    )
]

LANGUAGE_CODE = "en-gb"
LOCALE_PATHS = [BASE_DIR / "locale"]
LANGUAGES = [("en", "English"), ("it", "Italiano"), ("ja", "日本語")]
TIME_ZONE = "UTC"
USE_TZ = True

STATIC_URL = "static/"
STATIC_ROOT = BASE_DIR / "staticfiles"
STATICFILES_DIRS = [BASE_DIR / "static"]
STORAGES = {
    "default": {"BACKEND": "django.core.files.storage.FileSystemStorage"},
    "staticfiles": {"BACKEND": "whitenoise.storage.CompressedManifestStaticFilesStorage"},
}
WHITENOISE_MANIFEST_STRICT = False

SESSION_COOKIE_HTTPONLY = True
SESSION_COOKIE_SAMESITE = "Lax"
X_FRAME_OPTIONS = "DENY"
SECURE_CONTENT_TYPE_NOSNIFF = True
SECURE_REFERRER_POLICY = "same-origin"
CAIR_HTTPS = environment.flag("CAIR_HTTPS")
LANGUAGE_COOKIE_SAMESITE = "Lax"
LANGUAGE_COOKIE_HTTPONLY = True
SESSION_COOKIE_SECURE = CSRF_COOKIE_SECURE = LANGUAGE_COOKIE_SECURE = CAIR_HTTPS
SECURE_SSL_REDIRECT = CAIR_HTTPS
SECURE_HSTS_SECONDS = 31_536_000 if CAIR_HTTPS else 0
SECURE_HSTS_INCLUDE_SUBDOMAINS = SECURE_HSTS_PRELOAD = CAIR_HTTPS
# Calls among our own machines: they are asked and answered in plain HTTP.
SECURE_REDIRECT_EXEMPT = ["^livez$", "^readyz$", "^metrics$"]
SECURE_PROXY_SSL_HEADER = ("HTTP_X_FORWARDED_PROTO", "https") if CAIR_HTTPS else None

# What the service accepts and how it talks.
CAIR_LANGUAGE = environment.text("CAIR_LANGUAGE", "en")
CAIR_CULTURE = environment.text("CAIR_CULTURE", "EN")
CAIR_ONTOLOGY_IRI = environment.ontology_iri("CAIR_ONTOLOGY_IRI", "urn:cair:kb")
CAIR_LONGEST_BODY = environment.number("CAIR_LONGEST_BODY", 200_000, least=1000)
CAIR_LONGEST_INFLATED = environment.number("CAIR_LONGEST_INFLATED", 400_000, least=1000)
CAIR_LONGEST_ONTOLOGY = environment.number("CAIR_LONGEST_ONTOLOGY", 64_000_000, least=1000)
CAIR_LONGEST_SENTENCE = environment.number("CAIR_LONGEST_SENTENCE", 1000, least=10, most=100_000)
CAIR_LONGEST_STATE = environment.number("CAIR_LONGEST_STATE", 64_000, least=1000)
CAIR_DEEPEST_JSON = environment.number("CAIR_DEEPEST_JSON", 20, least=3, most=500)
CAIR_POLL_SECONDS = environment.number("CAIR_POLL_SECONDS", 1, least=1, most=3600)
CAIR_PLAN_MANAGER_URL = environment.text("CAIR_PLAN_MANAGER_URL")
CAIR_DIALOGUE_MANAGER_URL = environment.text("CAIR_DIALOGUE_MANAGER_URL")
CAIR_SERVICE_SECONDS = environment.number("CAIR_SERVICE_SECONDS", 3, least=1, most=60)
CAIR_SERVICE_KEY = environment.text("CAIR_SERVICE_KEY")
CAIR_KEYS_REQUIRED = environment.flag("CAIR_KEYS_REQUIRED")
CAIR_CHAT_RATE = environment.number("CAIR_CHAT_RATE", 30, most=100_000)
CAIR_ADDRESS_RATE = environment.number("CAIR_ADDRESS_RATE", 0, most=1_000_000)
CAIR_TRUSTED_PROXIES = environment.networks("CAIR_TRUSTED_PROXIES")
CAIR_LOGIN_FAILURES = environment.number("CAIR_LOGIN_FAILURES", 5, least=1, most=1000)
CAIR_LOGIN_MINUTES = environment.number("CAIR_LOGIN_MINUTES", 15, least=1, most=1440)
# Long uploads wait here, not where other users of the machine see them.
FILE_UPLOAD_TEMP_DIR = str(VAR) if VAR.is_dir() else None
DATA_UPLOAD_MAX_MEMORY_SIZE = 5_000_000
DATA_UPLOAD_MAX_NUMBER_FIELDS = 5_000  # an intent with many sentences

REST_FRAMEWORK = {
    "DEFAULT_AUTHENTICATION_CLASSES": [],
    "DEFAULT_PERMISSION_CLASSES": [],
    "UNAUTHENTICATED_USER": None,
    "DEFAULT_RENDERER_CLASSES": ["cair_site.messages.JSONRenderer"],
    "DEFAULT_PARSER_CLASSES": ["cair_site.messages.BodyParser"],
    "DEFAULT_CONTENT_NEGOTIATION_CLASS": "cair_site.messages.AlwaysJSON",
    "EXCEPTION_HANDLER": "cair_site.errors.answer_error",
    "DEFAULT_SCHEMA_CLASS": "cair_site.openapi_schema.Schema",
}
SPECTACULAR_SETTINGS = {
    "TITLE": "CAIR",
    "DESCRIPTION": "A conversation for robots: the Hub, the Plan Manager, the Dialogue Manager.",
    "VERSION": "1",
    "SERVE_INCLUDE_SCHEMA": False,
    "SCHEMA_PATH_PREFIX": "/api/v1/",
    "APPEND_COMPONENTS": {
        "securitySchemes": {"ApiKey": {"type": "apiKey", "in": "header", "name": "X-Api-Key"}}
    },
    "SWAGGER_UI_DIST": "SIDECAR",
    "SWAGGER_UI_FAVICON_HREF": "SIDECAR",
    "REDOC_DIST": "SIDECAR",
}

# What operators see.
CAIR_METRICS_TOKEN = environment.text("CAIR_METRICS_TOKEN")
CAIR_ACCESS_LOG = environment.flag("CAIR_ACCESS_LOG")
CAIR_SLOW_MS = environment.number("CAIR_SLOW_MS", 0, most=60_000)
CAIR_SLOW_A_MINUTE = environment.number("CAIR_SLOW_A_MINUTE", 10, least=1, most=10_000)
CAIR_LOG_FORMAT = environment.choice("CAIR_LOG_FORMAT", tuple(log_lines.FORMATTERS))
LOG_LEVELS = ("INFO", "DEBUG", "WARNING", "ERROR", "CRITICAL")
LOGGING = {
    "version": 1,
    "disable_existing_loggers": False,
    "formatters": {"ours": {"()": log_lines.FORMATTERS[CAIR_LOG_FORMAT]}},
    "filters": {"without_words": {"()": log_lines.WithoutWords}},
    "handlers": {
        "console": {
            "class": "logging.StreamHandler",
            "formatter": "ours",
            "filters": ["without_words"],
        }
    },
    "root": {"handlers": ["console"], "level": environment.choice("CAIR_LOG_LEVEL", LOG_LEVELS)},
    # Who sends nonsense is told so; our log is not theirs to fill.
    "loggers": {"django.request": {"level": "ERROR"}},
}
