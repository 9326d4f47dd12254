"""Settings of the site, all from the environment (docs/settings.md lists every variable)."""

from pathlib import Path

from cair_site import environment

BASE_DIR = Path(__file__).resolve().parent.parent
VAR = Path(environment.text("CAIR_VAR", str(BASE_DIR / "var"))).resolve()

DEBUG = environment.flag("CAIR_DEBUG")
SECRET_KEY = environment.secret("CAIR_SECRET_KEY", VAR)
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
DATABASES = {
    "default": environment.database(environment.text("DATABASE_URL"), VAR / "cair.sqlite3")
}
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
CAIR_KEYS_REQUIRED = environment.flag("CAIR_KEYS_REQUIRED")
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
    "DEFAULT_SCHEMA_CLASS": "drf_spectacular.openapi.AutoSchema",
}
SPECTACULAR_SETTINGS = {
    "TITLE": "CAIR",
    "DESCRIPTION": "A conversation for robots: the Hub, the Plan Manager, the Dialogue Manager.",
    "VERSION": "1",
    "SERVE_INCLUDE_SCHEMA": False,
    "SCHEMA_PATH_PREFIX": "/api/v1/",
    "SWAGGER_UI_DIST": "SIDECAR",
    "SWAGGER_UI_FAVICON_HREF": "SIDECAR",
    "REDOC_DIST": "SIDECAR",
}

LOG_LEVELS = ("INFO", "DEBUG", "WARNING", "ERROR", "CRITICAL")
LOGGING = {
    "version": 1,
    "disable_existing_loggers": False,
    "formatters": {"plain": {"format": "%(asctime)s %(levelname)s %(name)s: %(message)s"}},
    "handlers": {"console": {"class": "logging.StreamHandler", "formatter": "plain"}},
    "root": {"handlers": ["console"], "level": environment.choice("CAIR_LOG_LEVEL", LOG_LEVELS)},
    # Who sends nonsense is told so; our log is not theirs to fill.
    "loggers": {"django.request": {"level": "ERROR"}},
}
