"""The pages of releases: what each changed, and the ways back."""

import io
import zipfile
from pathlib import Path

import pytest
from django.test import Client
from django.urls import reverse
from pytest_django import DjangoAssertNumQueries

from authoring.releases import releases
from dialogue.content import read_knowledge
from dialogue.models import DraftVersion, Publication, Sentence, TopicInstance, TopicName
from dialogue.models import Frame as FrameRow
from dialogue.publishing import publish
from ontology_io.files.folder import Folder, read_folder
from tests.authoring.people import logged_in


def change_milk(name: str) -> None:
    TopicName.objects.filter(topic__key="Milk", language="en").update(name=name)


@pytest.fixture
def two_releases(small_draft: Folder) -> tuple[int, int]:
    first = publish(note="The first drinks")
    change_milk("warm milk")
    return first.pk, publish(note="Warm").pk


def get(client: Client, name: str, *arguments: object) -> str:
    response = client.get(reverse(f"admin:{name}", args=arguments))
    assert response.status_code == 200
    return str(response.content.decode())


def damage(number: int) -> None:
    row = Publication.objects.get(pk=number)
    Publication.objects.filter(pk=number).update(data=bytes(row.data)[:-3] + b"xyz")


def test_the_list_says_which_release_is_served(
    admin_client: Client,
    two_releases: tuple[int, int],
    django_assert_max_num_queries: DjangoAssertNumQueries,
) -> None:
    for place in range(60):
        Publication.objects.create(checksum=str(place), data=b"")
    with django_assert_max_num_queries(10):
        page = get(admin_client, "releases")
    assert page.count("served now") == 1
    assert "Page 1 of 2" in page


def test_a_release_tells_what_it_changed(
    admin_client: Client, two_releases: tuple[int, int]
) -> None:
    page = get(admin_client, "release", two_releases[1])
    assert "Milk: its name in English." in page
    assert "<ins>warm </ins>milk" in page
    first = get(admin_client, "release", two_releases[0])
    assert "5 topics added: " in first
    assert "What the first release held" in first


def test_what_a_release_changed_is_computed_once(
    admin_client: Client, two_releases: tuple[int, int], monkeypatch: pytest.MonkeyPatch
) -> None:
    get(admin_client, "release", two_releases[1])
    monkeypatch.setattr(releases, "notes", None)
    get(admin_client, "release", two_releases[1])


def test_a_damaged_release_is_told_of_and_can_do_no_harm(
    admin_client: Client, two_releases: tuple[int, int]
) -> None:
    releases._kept.clear()
    first = two_releases[0]
    damage(first)
    assert "A release is damaged" in get(admin_client, "release", first)
    assert "A release is damaged" in get(admin_client, "release", two_releases[1])
    for name in ("release_back", "release_draft"):
        page = get(admin_client, name, first)
        assert "A release is damaged" in page
        data = {"newest": str(two_releases[1]), "draft": str(releases.draft_version())}
        response = admin_client.post(reverse(f"admin:{name}", args=[first]), data, follow=True)
        assert "is damaged and cannot be read. Choose another one." in response.content.decode()
    response = admin_client.get(reverse("admin:release_files", args=[first]), follow=True)
    assert "is damaged and cannot be read" in response.content.decode()
    assert Publication.objects.count() == 2


def test_the_files_of_a_release_are_its_content(
    admin_client: Client, two_releases: tuple[int, int], tmp_path: Path
) -> None:
    response = admin_client.get(reverse("admin:release_files", args=[two_releases[0]]))
    assert response["Content-Type"] == "application/zip"
    zipfile.ZipFile(io.BytesIO(response.content)).extractall(tmp_path)
    base = read_folder(tmp_path / "content").base
    names = {topic.key: topic.names["en"]["name"] for topic in base.knowledge.topics}
    assert names["Milk"] == "milk"


def test_going_back_asks_first_and_makes_a_new_release(
    admin_client: Client, two_releases: tuple[int, int]
) -> None:
    first, second = two_releases
    page = get(admin_client, "release_back", first)
    assert "<del>warm </del>milk" in page
    assert Publication.objects.count() == 2
    address = reverse("admin:release_back", args=[first])
    response = admin_client.post(address, {"newest": str(second)}, follow=True)
    newest = Publication.objects.first()
    assert newest is not None
    assert newest.checksum == Publication.objects.get(pk=first).checksum
    assert f"it is served again, as release {newest.pk}" in response.content.decode()
    assert newest.author is not None


def test_going_back_is_not_done_past_a_release_nobody_saw(
    admin_client: Client, two_releases: tuple[int, int]
) -> None:
    first = two_releases[0]
    address = reverse("admin:release_back", args=[first])
    response = admin_client.post(address, {"newest": str(first)}, follow=True)
    assert "Another release came meanwhile" in response.content.decode()
    assert Publication.objects.count() == 2


def test_the_draft_can_be_made_to_say_what_a_release_said(
    admin_client: Client, two_releases: tuple[int, int]
) -> None:
    before = read_knowledge()
    Sentence.objects.filter(frame__key="GreenTea.c1", language="en").update(text="Gone.")
    TopicInstance.objects.filter(topic__key="Milk").update(likeliness="0.9")
    FrameRow.objects.get(key="Drink.q1").delete()
    page = get(admin_client, "release_draft", two_releases[1])
    assert "New sentence Drink.q1 (yes/no question):" in page
    data = {"draft": str(releases.draft_version())}
    address = reverse("admin:release_draft", args=[two_releases[1]])
    lines = DraftVersion.history.count()
    response = admin_client.post(address, data, follow=True)
    assert "Robots say it once you publish" in response.content.decode()
    assert read_knowledge() == before
    told = DraftVersion.history.first().history_change_reason
    assert told == f"The draft says what release {two_releases[1]} said."
    assert DraftVersion.history.count() == lines + 1


def test_a_draft_that_changed_meanwhile_is_not_written_over(
    admin_client: Client, two_releases: tuple[int, int]
) -> None:
    for draft in (str(releases.draft_version() - 1), "", "x", "9" * 30):
        address = reverse("admin:release_draft", args=[two_releases[0]])
        response = admin_client.post(address, {"draft": draft}, follow=True)
        assert "nothing was written" in response.content.decode()
    names = TopicName.objects.filter(topic__key="Milk", language="en")
    assert names.get().name == "warm milk"


def test_an_unknown_release_is_not_found(admin_client: Client, small_draft: Folder) -> None:
    for name in ("release", "release_files", "release_back", "release_draft"):
        assert admin_client.get(reverse(f"admin:{name}", args=[987])).status_code == 404


@pytest.mark.parametrize(
    ("role", "may"),
    [
        ("author", {"releases", "release", "release_files"}),
        ("researcher", {"releases", "release", "release_files"}),
        ("publisher", {"releases", "release", "release_files", "release_back", "release_draft"}),
        (
            "administrator",
            {"releases", "release", "release_files", "release_back", "release_draft"},
        ),
        ("nobody", set()),
    ],
)
def test_each_role_opens_what_it_may(
    role: str, may: set[str], two_releases: tuple[int, int]
) -> None:
    client = logged_in("" if role == "nobody" else role)
    for name in ("releases", "release", "release_files", "release_back", "release_draft"):
        arguments = [] if name == "releases" else [two_releases[0]]
        status = client.get(reverse(f"admin:{name}", args=arguments)).status_code
        assert (status == 200) == (name in may), (role, name, status)
