"""The published topics: what there is to talk about."""

from tests.api.conftest import Api


def test_topics_come_fifty_a_page(api: Api) -> None:
    page = api.get("topics/")
    assert page["page"] == 1
    assert page["pages"] == -(-page["count"] // 50)
    assert len(page["results"]) == min(50, page["count"])
    assert set(page["results"][0]) == {"name", "names"}


def test_pages_do_not_overlap_and_leave_none_out(api: Api) -> None:
    pages = range(1, api.get("topics/")["pages"] + 1)
    names = [row["name"] for page in pages for row in api.get("topics/", page=page)["results"]]
    assert len(names) == len(set(names)) == api.get("topics/")["count"]


def test_a_page_that_is_not_there_is_the_nearest(api: Api) -> None:
    last = api.get("topics/")["pages"]
    assert api.get("topics/", page=999_999)["page"] == last
    assert api.get("topics/", page="x")["page"] == 1
    assert api.get("topics/", page="9" * 5000)["page"] == 1


def test_topics_are_found_by_their_name_in_any_language(api: Api) -> None:
    for search in ("MUSIC", "musica", "音楽"):
        found = {row["name"] for row in api.get("topics/", search=search)["results"]}
        assert "Music" in found


def test_a_search_may_find_nothing(api: Api) -> None:
    answer = api.get("topics/", search="\x00 no such topic")
    assert (answer["count"], answer["pages"], answer["results"]) == (0, 1, [])


def test_one_topic_tells_all_about_itself(api: Api) -> None:
    topic = api.get("topics/Music/")
    assert set(topic) == {
        "name",
        "names",
        "ancestors",
        "children",
        "links",
        "keywords",
        "likeliness",
        "sentences",
    }
    assert set(topic["names"]) == {"en", "it", "ja"}
    assert set(topic["likeliness"]) == {"EN", "IT", "JP", "IN"}


def test_children_know_their_parents(api: Api) -> None:
    for child in api.get("topics/Music/")["children"]:
        assert "Music" in api.get(f"topics/{child}/")["ancestors"]


def test_an_unknown_topic_says_so(api: Api) -> None:
    answer = api.client.get("/api/v1/topics/NoSuchTopic/")
    assert answer.status_code == 404
    assert answer.json()["error"]["code"] == "not_found"
    assert "NoSuchTopic" in answer.json()["error"]["message"]
