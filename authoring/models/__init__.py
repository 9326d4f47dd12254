"""The rows of the authoring pages themselves; one module a model."""

from authoring.models.api_key import ApiKey as ApiKey
from authoring.models.check_run import CheckRun as CheckRun
from authoring.models.check_run import PublishRun as PublishRun
from authoring.models.conversation import Conversation as Conversation
from authoring.models.login_attempts import LoginAttempts as LoginAttempts
