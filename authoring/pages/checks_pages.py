"""The pages of checks, publishing and releases, as rows of authoring.pages.table."""

from django.utils.translation import gettext_lazy as _

from authoring.pages import releases
from authoring.pages.checks import checks
from authoring.pages.page import Page
from authoring.pages.publish import publish, result, status

_SEE, _PUBLISH, _EXPORT = (
    "dialogue.view_publication",
    "dialogue.publish_draft",
    "dialogue.export_content",
)
_ONE = "releases/<int:number>/"

CHECK_PAGES = (
    Page("checks", "checks/", checks, "dialogue.view_topic", _("Checks"), 50),
    Page("publish", "publish/", publish, _SEE, _("Publish"), 60),
    Page("publish_status", "publish/<int:number>/", status, _SEE),
    Page("publish_result", "publish/<int:number>/result/", result, _SEE),
    Page("releases", "releases/", releases.release_list, _SEE, _("Releases"), 70),
    Page("release", _ONE, releases.release, _SEE),
    Page("release_files", f"{_ONE}content.zip", releases.files, _EXPORT),
    Page("release_back", f"{_ONE}back/", releases.back, _PUBLISH),
    Page("release_draft", f"{_ONE}draft/", releases.take_back, _PUBLISH),
)
