"""Every page and every form, tried as each role and as nobody: new ones are tried by themselves.

What a role may do is said once here, by permission; what is closed to everybody (nobody adds a
release by hand) is what a superuser is refused too.
"""

from collections.abc import Iterator

import pytest
from django.contrib import admin
from django.contrib.auth.models import User
from django.db.models import Model
from django.http import HttpResponse
from django.test import Client
from django.urls import URLPattern, URLResolver, reverse

from authoring.admin.base import ContentAdmin
from authoring.keys import make_key
from authoring.pages.page import Page
from authoring.pages.table import PAGES
from authoring.roles import ADMINISTRATOR, AUTHOR, PUBLISHER, RESEARCHER
from tests.authoring.people import PASSWORD, logged_in

pytestmark = pytest.mark.usefixtures("small_draft")
ROLES = (AUTHOR, PUBLISHER, RESEARCHER, ADMINISTRATOR)
EVERYBODY, WRITERS = frozenset(ROLES), frozenset((AUTHOR, PUBLISHER, ADMINISTRATOR))
PUBLISHERS, ADMINISTRATORS = frozenset((PUBLISHER, ADMINISTRATOR)), frozenset((ADMINISTRATOR,))
#: Who may what: the most special row that fits holds. * stands for anything.
TABLE = {
    "dialogue.publish_draft": PUBLISHERS,
    "dialogue.export_content": EVERYBODY,
    "authoring.*_apikey": ADMINISTRATORS,
    "auth.*": ADMINISTRATORS,
    "dialogue.view_*": EVERYBODY,
    "plans.view_*": EVERYBODY,
    "authoring.view_*": EVERYBODY,
    "dialogue.*_publication": ADMINISTRATORS,
    "dialogue.*": WRITERS,
    "plans.*": WRITERS,
    "authoring.*": WRITERS,
}
VERBS = {
    "changelist": "view",
    "add": "add",
    "change": "view",
    "delete": "delete",
    "history": "view",
}
#: What any member of staff may open: the start, one's password, the words of scripts.
FOR_STAFF = {"index", "login", "logout", "password_change", "password_change_done", "jsi18n"}
FOR_STAFF |= {"view_on_site"}
MODELS = list(admin.site._registry)


def who(permission: str) -> frozenset[str]:
    """Return the roles that have a permission, by the table."""
    app, _point, name = permission.partition(".")
    verb, _line, model = name.partition("_")
    for row in (permission, f"{app}.{verb}_*", f"{app}.*_{model}", f"{app}.*"):
        special = TABLE.get(f"{app}.*_{model}") if verb != "view" or model == "apikey" else None
        if permission not in TABLE and special is not None:
            return special
        if row in TABLE:
            return TABLE[row]
    return frozenset()


@pytest.fixture(autouse=True)
def _a_key(small_draft: object) -> None:
    make_key("robot", None, None)


def browser(role: str) -> Client:
    """Return the browser of a role, which sees a fault as an answer."""
    client = logged_in(role)
    client.raise_request_exception = False
    return client


@pytest.fixture
def root() -> Client:
    client = Client(raise_request_exception=False)
    client.force_login(User.objects.create_superuser("root", password=PASSWORD))
    return client


def refused(answer: HttpResponse) -> bool:
    """Say whether a person was kept out, also by being sent to the start; a fault is no answer."""
    assert answer.status_code < 500, answer.request["PATH_INFO"]
    sent = answer.headers["Location"] if answer.status_code == 302 else ""
    return answer.status_code == 403 or "/login/" in sent or sent == "/admin/"


def sample(pattern: URLPattern) -> dict[str, str]:
    """Return something for each variable of an address."""
    kinds = pattern.pattern.converters
    return {
        name: "1" if "Int" in type(kind).__name__ else "x" for name, kind in kinds.items()
    } or dict.fromkeys(pattern.pattern.regex.groupindex, "1")


def address(page: Page) -> str:
    return "/admin/" + fill(next(one for one in patterns() if one.name == page.name))


def fill(pattern: URLPattern) -> str:
    text = str(pattern.pattern)
    for name, value in sample(pattern).items():
        for kind in ("str", "int", "slug", "path", "uuid"):
            text = text.replace(f"<{kind}:{name}>", value)
        text = text.replace(f"<{name}>", value)
    return text


def patterns() -> list[URLPattern]:
    return [one for one in admin.site.get_urls() if isinstance(one, URLPattern)]


def every_address() -> Iterator[tuple[str, str]]:
    """Yield name and address of everything below /admin/, forms and extra views of forms too."""
    for one in admin.site.get_urls():
        if isinstance(one, URLPattern) and one.name:
            yield one.name, "/admin/" + fill(one)
        elif isinstance(one, URLResolver):
            for inner in one.url_patterns:
                if isinstance(inner, URLPattern) and inner.name:
                    yield inner.name, f"/admin/{one.pattern}" + fill(inner)


def form(model: type[Model], kind: str) -> str:
    name = f"admin:{model._meta.app_label}_{model._meta.model_name}_{kind}"
    if kind in ("changelist", "add"):
        return reverse(name)
    row = model._default_manager.order_by("-pk").first()
    return reverse(name, args=(row.pk if row else 1,))


def permission_for(model: type[Model], verb: str) -> str:
    return f"{model._meta.app_label}.{verb}_{model._meta.model_name}"


@pytest.mark.parametrize("role", ROLES)
def test_each_role_opens_its_pages_and_no_others(role: str) -> None:
    client = browser(role)
    found = {page.name for page in PAGES if not refused(client.get(address(page)))}
    assert found == {page.name for page in PAGES if role in who(page.permission)}


@pytest.mark.parametrize("role", ROLES)
def test_no_role_posts_to_a_page_it_cannot_open(role: str) -> None:
    client = browser(role)
    for page in PAGES:
        if role not in who(page.permission):
            assert refused(client.post(address(page))), page.name


@pytest.mark.parametrize("role", ROLES)
def test_each_role_opens_its_forms_and_no_others(role: str, root: Client) -> None:
    client = browser(role)
    for model in MODELS:
        for kind, verb in VERBS.items():
            place = form(model, kind)
            closed = refused(root.get(place))
            may = role in who(permission_for(model, verb)) and not closed
            assert refused(client.get(place)) != may, (model.__name__, kind)


@pytest.mark.parametrize("role", ROLES)
def test_no_role_changes_what_it_only_reads(role: str) -> None:
    client = browser(role)
    for model in MODELS:
        for kind, verb in {"add": "add", "change": "change", "delete": "delete"}.items():
            if role not in who(permission_for(model, verb)):
                assert refused(client.post(form(model, kind), {"post": "yes"})), (model, kind)


@pytest.mark.parametrize("model", MODELS, ids=lambda model: model.__name__)
def test_researchers_see_forms_without_buttons_to_save(model: type[Model]) -> None:
    if not isinstance(admin.site._registry[model], ContentAdmin):
        pytest.skip("not part of the draft")
    page = browser(RESEARCHER).get(form(model, "change"))
    assert page.status_code == 200
    assert not page.context["has_change_permission"]
    assert 'name="_save"' not in page.content.decode()
    assert "deletelink" not in page.content.decode()


@pytest.mark.parametrize("model", MODELS, ids=lambda model: model.__name__)
def test_what_experts_write_is_open_to_authors(model: type[Model]) -> None:
    if not isinstance(admin.site._registry[model], ContentAdmin):
        pytest.skip("not part of the draft")
    client = browser(AUTHOR)
    for kind in VERBS:
        assert client.get(form(model, kind)).status_code == 200, kind
    assert 'name="_save"' in client.get(form(model, "change")).content.decode()


def test_nobody_opens_anything_without_logging_in() -> None:
    client = Client(raise_request_exception=False)
    for name, place in every_address():
        if name != "login":
            for answer in (client.get(place), client.post(place)):
                assert refused(answer) or name == "logout", (name, answer.status_code)


def test_staff_without_a_role_opens_only_the_start() -> None:
    client = browser("")
    for name, place in every_address():
        if name not in FOR_STAFF:
            answer = client.get(place)
            assert refused(answer) or answer.status_code in (404, 405), (name, answer.status_code)


def test_a_user_who_is_no_staff_opens_nothing() -> None:
    client = Client(raise_request_exception=False)
    client.force_login(User.objects.create_user("visitor"))
    for page in PAGES:
        assert refused(client.get(address(page))), page.name


def test_every_permission_of_a_page_is_one_that_exists() -> None:
    for page in PAGES:
        assert who(page.permission), page.name
        assert User(is_superuser=True, is_active=True).has_perm(page.permission)


def test_the_menu_shows_each_role_only_what_it_may_open() -> None:
    for role in ROLES:
        shown = {str(one["title"]) for one in browser(role).get("/admin/").context["menu"]}
        may = {str(one.title) for one in PAGES if one.title and role in who(one.permission)}
        assert shown == may, role
