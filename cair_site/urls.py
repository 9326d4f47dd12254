"""Addresses: the chat, the API, the clients that exist, the admin, health."""

from django.contrib import admin
from django.urls import include, path, re_path
from django.views.i18n import set_language
from rest_framework.routers import SimpleRouter

from cair_site import compat, operations, pages
from cair_site.hub import HubViewSet
from cair_site.ontology_api import OntologyViewSet
from cair_site.person_api import PersonView
from dialogue.api import DialogueViewSet
from dialogue.topics_api import TopicViewSet
from plans.api import ActionViewSet, IntentViewSet, PlanViewSet

router = SimpleRouter()
router.register("hub", HubViewSet, basename="hub")
router.register("plan", PlanViewSet, basename="plan")
router.register("dialogue", DialogueViewSet, basename="dialogue")
router.register("topics", TopicViewSet, basename="topics")
router.register("intents", IntentViewSet, basename="intents")
router.register("actions", ActionViewSet, basename="actions")
router.register("ontology", OntologyViewSet, basename="ontology")

urlpatterns = [
    path("", pages.chat, name="chat"),
    path("admin/language/", set_language, name="set_language"),
    path("admin/", admin.site.urls),
    path("api/v1/dialogue/person/", PersonView.as_view(), name="dialogue-person"),
    path("api/v1/", include(router.urls)),
    path("api/schema/", pages.schema, name="schema"),
    path("api/docs/", pages.docs, name="docs"),
    re_path(r"^(?:(?P<language>[a-z]{2})/)?CAIR_hub(?:/start)?/?$", compat.hub, name="compat"),
    path("livez", operations.livez),
    path("readyz", operations.readyz),
    path("metrics", operations.metrics),
]
handler400 = "cair_site.errors.bad_request"
handler404 = "cair_site.errors.not_found"
handler500 = "cair_site.errors.server_error"
