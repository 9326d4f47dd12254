"""The parts of the NAOqi client alone: what it reads, hears, shows and says."""

import datetime
import json

import pytest
from cair_pepper.__main__ import main
from cair_pepper.calendar_words import spoken_date, spoken_time
from cair_pepper.ears import understood, without_name
from cair_pepper.labels import LABELS
from cair_pepper.people import People
from cair_pepper.places import Places
from cair_pepper.services import Services, UnableError
from cair_pepper.settings import DEFAULTS, SettingsError, read_settings
from cair_pepper.skills.clock import _seconds_until
from cair_pepper.tablet import DIALOGUE, EXECUTION, PRIVACY
from cair_pepper.voice import plain
from cair_pepper.words import (
    DIRECTIONS,
    NAMES,
    PLACES,
    TEXTS,
    VOCABULARY,
    listed,
    meant,
    without_frame,
)

from tests.clients.naoqi.conftest import CLIENT

SATURDAY = datetime.datetime(2026, 11, 21, 15, 20)  # noqa: DTZ001 - a robot's clock has no zone


def test_settings_left_out_have_their_defaults():
    settings = read_settings('{"robot_name": "Nao", "behaviours": {"hug": "my/hug"}}')
    assert settings["robot_name"] == "Nao"
    assert settings["behaviours"]["hug"] == "my/hug"
    assert settings["behaviours"]["hello"].endswith("Hey_1")
    assert set(settings) == set(DEFAULTS)


@pytest.mark.parametrize(
    ("given", "named"),
    [
        ('{"languages": "en"}', "languages"),
        ('{"language": "fr"}', "language"),
        ('{"volume": "loud"}', "volume"),
        ('{"volume": true}', "volume"),
        ('{"behaviours": {"hug": 3}}', "behaviours"),
        ('{"media": {"playsong": "x"}}', "media"),
        ("[]", "object"),
        ("{", "JSON"),
    ],
)
def test_a_wrong_setting_is_refused_by_name(given, named):
    with pytest.raises(SettingsError, match=named):
        read_settings(given)


def test_every_text_is_there_in_each_language_with_the_same_places_to_fill():
    for name, texts in TEXTS.items():
        assert set(texts) == {"en", "it", "ja"}, name
        assert len({text.count("{") for text in texts.values()}) == 1, name
    assert all(len(three) == 3 and all(three) for three in LABELS.values())
    assert set(VOCABULARY) == {"en", "it", "ja"}


@pytest.mark.parametrize(
    ("value", "sentence"),
    [
        ("I love music", "I love music"),
        (["I love music", 0.9], "I love music"),
        (["I love music", 0.1], ""),
        (["<...> play a song <...>", 0.5, "sing", 0.2], "play a song"),
        ([], ""),
        (None, ""),
        (3, ""),
    ],
)
def test_what_a_recogniser_tells_is_understood(value, sentence):
    assert understood(value, 0.4) == sentence


@pytest.mark.parametrize(
    ("said", "left"),
    [
        ("Pepper, play a song", "play a song"),
        ("pepper play a song", "play a song"),
        ("Play a song, Pepper", "Play a song"),
        ("Pepper", "Pepper"),
        ("I like pepper", "I like pepper"),
        ("Peppermint tea", "Peppermint tea"),
    ],
)
def test_the_robots_name_is_no_part_of_what_is_said(said, left):
    assert without_name(said, "Pepper") == left


def test_the_voice_gets_no_commands():
    assert plain("Sing \\vct=50\\ ^start(x) #1  now") == "Sing start(x) 1 now"


@pytest.mark.parametrize(
    ("answer", "way"),
    [
        ("To the left please", "left"),
        ("vai a destra", "right"),
        ("前に進んで", "forward"),
        ("I don't know", None),
        (None, None),
    ],
)
def test_a_direction_is_found_in_an_answer(answer, way):
    assert meant(answer, DIRECTIONS) == way


@pytest.mark.parametrize(
    ("answer", "frames", "language", "name"),
    [
        ("My name is Anna.", NAMES, "en", "Anna"),
        ("Anna", NAMES, "en", "Anna"),
        ("Mi chiamo Zoë", NAMES, "it", "Zoë"),
        ("私の名前は花子です", NAMES, "ja", "花子"),
        ("田中と申します", NAMES, "ja", "田中"),
        ("This is the kitchen", PLACES, "en", "kitchen"),
        ("the garden", PLACES, "en", "garden"),
        ("kitchen", PLACES, "en", "kitchen"),
        ("Questa è la cucina", PLACES, "it", "cucina"),
        ("Questo è l'ingresso", PLACES, "it", "ingresso"),
        ("Indice", PLACES, "it", "Indice"),
        ("ここは台所です", PLACES, "ja", "台所"),
    ],
)
def test_a_name_is_found_in_an_answer(answer, frames, language, name):
    assert without_frame(answer, frames, language) == name


def test_names_are_listed_as_one_says_them():
    assert listed(["A", "B", "C"], "en") == "A, B and C"
    assert listed(["A", "B"], "it") == "A e B"
    assert listed(["A"], "ja") == "A"


@pytest.mark.parametrize(
    ("language", "date", "time"),
    [
        ("en", "Today is Saturday, the 21st of November.", "It is 20 past 3 in the afternoon."),
        ("it", "Oggi è sabato 21 novembre.", "Sono le 15 e 20."),
        ("ja", "今日は11月21日、土曜日です。", "今は午後3時20分です。"),
    ],
)
def test_date_and_time_are_said_in_the_language(language, date, time):
    assert spoken_date(SATURDAY, language) == date
    assert spoken_time(SATURDAY, language) == time


@pytest.mark.parametrize(
    ("hour", "minute", "english", "italian"),
    [
        (0, 0, "It is midnight.", "È mezzanotte."),
        (12, 0, "It is noon.", "È mezzogiorno."),
        (11, 45, "It is a quarter to noon.", "Sono le 11 e 45."),
        (23, 59, "It is 1 minute to midnight.", "Sono le 23 e 59."),
        (1, 15, "It is a quarter past 1 in the morning.", "È l'una e un quarto."),
        (9, 0, "It is 9 o'clock in the morning.", "Sono le 9."),
        (20, 30, "It is half past 8 in the evening.", "Sono le 20 e mezza."),
    ],
)
def test_times_are_said_as_people_say_them(hour, minute, english, italian):
    moment = SATURDAY.replace(hour=hour, minute=minute)
    assert spoken_time(moment, "en") == english
    assert spoken_time(moment, "it") == italian


class _Clock:
    now = staticmethod(lambda: SATURDAY)
    ask = staticmethod(lambda question: None)
    text = staticmethod(str)


@pytest.mark.parametrize(
    ("day", "time", "hours"),
    [
        (None, "1620", 1),
        (None, "0720", 16),
        ("tomorrow", "1520", 24),
        ("saturday", "1500", 7 * 24 - 1 / 3),
        ("sunday", "1520", 24),
        ("in_2_days", "1520", 48),
        ("1122", "1520", 24),
        ("sometime", "1520", None),
        (None, None, None),
    ],
)
def test_an_alarm_knows_how_long_to_wait(day, time, hours):
    seconds = _seconds_until(_Clock, {"day": day, "time": time})
    assert seconds == (None if hours is None else pytest.approx(hours * 3600, abs=1))


def test_a_place_is_known_by_its_other_names_and_after_a_new_start(plain_pepper, tmp_path):
    services = Services(plain_pepper.session)
    places = Places(str(tmp_path / "new"), services)
    places.load()
    places.learn("Kitchen")
    file = tmp_path / "new" / "places.json"
    kept = json.loads(file.read_text())
    kept["places"]["kitchen"]["names"] = ["cucina"]
    file.write_text(json.dumps(kept))
    again = Places(str(tmp_path / "new"), services)
    again.load()
    assert again.knows("the kitchen")
    assert again.knows("Cucina")
    assert not again.knows("bagno")
    again.learn("cucina")
    assert again.names() == ["kitchen"]


def test_a_damaged_file_of_places_is_no_place(plain_pepper, tmp_path):
    (tmp_path / "places.json").write_text("[1")
    places = Places(str(tmp_path), Services(plain_pepper.session))
    places.load()
    assert places.names() == []


def test_a_map_is_made_once(plain_pepper, tmp_path):
    places = Places(str(tmp_path), Services(plain_pepper.session))
    assert places.explore(5) == "/home/nao/map.explo"
    assert json.loads((tmp_path / "places.json").read_text())["map"] == "/home/nao/map.explo"


def test_a_missing_service_is_unable_and_nothing_worse(plain_pepper):
    services = Services(plain_pepper.session)
    assert not services.has("ALTelepathy")
    assert services.quietly("ALTelepathy", "read", "Anna") is None
    with pytest.raises(UnableError, match=r"ALMotion\.fly"):
        services.call("ALMotion", "fly")


def test_each_person_has_a_talk_of_their_own(tmp_path):
    people = People(str(tmp_path), "Anna")
    assert people.present() == "Anna"
    people.keep("花子")
    assert People(str(tmp_path), "Anna").present() == "花子"
    assert len({people.talk_file(one) for one in ("Anna", "花子", "", "../x")}) == 4
    assert "/.." not in people.talk_file("../x").replace(str(tmp_path), "")


def test_the_example_of_settings_can_be_used():
    example = read_settings((CLIENT / "settings.example.json").read_text(encoding="utf-8"))
    assert example["server"].startswith("http")


def test_the_readme_names_every_setting():
    readme = (CLIENT / "README.md").read_text(encoding="utf-8")
    assert [name for name in DEFAULTS if f"`{name}`" not in readme] == []


def test_each_page_of_the_tablet_is_there():
    for mode in (DIALOGUE, EXECUTION, PRIVACY):
        assert 'id="text"' in (CLIENT / "html" / f"{mode}.html").read_text()


@pytest.mark.parametrize("pepper", ["qi"], indirect=True)
def test_the_program_makes_a_map_on_a_robot(pepper, tmp_path):
    settings = tmp_path / "settings.json"
    settings.write_text(json.dumps({"folder": str(tmp_path / "cair")}))
    assert main([str(settings), "--naoqi", pepper.address, "--explore", "5"]) == 0
    assert "navigation: explores 5 m" in pepper.notes.lines


@pytest.mark.parametrize("text", ["{", '{"language": "xx"}'])
def test_the_program_says_what_is_wrong_with_its_settings(text, tmp_path, caplog):
    settings = tmp_path / "settings.json"
    settings.write_text(text)
    assert main([str(settings)]) == 1
    assert main([str(tmp_path / "none.json")]) == 1
    assert caplog.records
