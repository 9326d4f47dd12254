"""Spreadsheets: what goes out comes back unchanged, and every change is seen before it is saved."""

import io
import zipfile

import openpyxl
import pytest
from django.http import HttpResponse
from django.test import Client
from django.utils import translation
from hypothesis import given
from hypothesis import settings as chosen
from hypothesis import strategies as st
from pytest_django import DjangoAssertNumQueries
from pytest_django.fixtures import Settings

from authoring.roles import ADMINISTRATOR, AUTHOR, PUBLISHER, RESEARCHER
from authoring.sheets.guarding import guarded, unguarded
from authoring.sheets.reading import read_table
from authoring.sheets.table import SHEETS
from authoring.sheets.tables import UnreadableError
from authoring.sheets.writing import CSV, XLSX, written
from dialogue.draft import draft_version
from dialogue.models import Frame, KeywordSet, Sentence, Topic, TopicInstance, TopicName
from plans.models import Intent, IntentTest, PlanSentence, Trigger
from tests.authoring.people import logged_in
from tests.authoring.sheet_files import (
    Lines,
    brought,
    changed,
    csv_of,
    line,
    lines_of,
    saved,
    taken,
    text,
    xlsx_of,
)

pytestmark = pytest.mark.usefixtures("small_draft")
KINDS = list(SHEETS)


@pytest.fixture
def author() -> Client:
    return logged_in(AUTHOR)


def counts(answer: HttpResponse) -> dict[str, int]:
    assert answer.status_code == 200, text(answer)[:500]
    return {kind: n for kind, n in answer.context["preview"].counts.items() if n}


def mistakes(answer: HttpResponse) -> list[tuple[int, str, str]]:
    """Return line, column and message of every mistake."""
    found = []
    for row in answer.context["preview"].wrong:
        found += [(row.number, "", message) for message in row.problems]
        found += [(row.number, c.column, one) for c in row.cells for one in c.problems]
    return found


# What goes out comes back.


@pytest.mark.parametrize("form", ["csv", "xlsx"])
@pytest.mark.parametrize("kind", KINDS)
def test_a_sheet_brought_back_as_it_was_changes_nothing(
    author: Client, kind: str, form: str
) -> None:
    answer = brought(author, kind, taken(author, kind, form), f"sheet.{form}")
    assert set(counts(answer)) == {"same"}
    assert not answer.context["sealed"]
    assert "Nothing changes" in text(answer)


@pytest.mark.parametrize("language", ["it", "ja"])
def test_a_sheet_is_the_same_whatever_language_the_person_reads(
    author: Client, language: str
) -> None:
    data = taken(author, "sentences")
    with translation.override(language):
        author.cookies["django_language"] = language
        assert taken(author, "sentences") == data
        assert set(counts(brought(author, "sentences", data))) == {"same"}


@chosen(deadline=None)
@given(st.lists(st.lists(st.text(max_size=20), min_size=3, max_size=3), max_size=5))
def test_any_text_survives_both_kinds_of_file(rows: list[list[str]]) -> None:
    lines = [["k", *(tidy(one) for one in row)] for row in rows]
    for form in (CSV, XLSX):
        data = written(form, "Any", ["key", "a", "b", "c"], lines)
        table = read_table(f"any.{form}", data, ["key"], "Any")
        assert [[*(one.strip() for one in row.texts.values())] for row in table.rows] == lines
        assert not any(row.faults for row in table.rows)


def tidy(some: str) -> str:
    """Return a text as a row of the draft may hold it."""
    kept = "".join(
        one for one in some if (one >= " " and one not in "\x7f\ufffe\uffff") or one == "\t"
    )
    return "".join(one for one in kept if not "\ud800" <= one <= "\udfff").strip()


@chosen(deadline=None)
@given(st.text(max_size=12))
def test_a_guarded_text_is_no_formula_and_comes_back(some: str) -> None:
    assert unguarded(guarded(some)) == some
    assert not guarded(some).startswith(("=", "+", "-", "@", "\t", "\r", "＝"))


def test_what_looks_like_a_formula_goes_out_harmless_and_comes_back(author: Client) -> None:
    for place, row in enumerate(Sentence.objects.filter(language="en").order_by("pk")[:6]):
        row.text = ("=1+1", "+39 is Italy.", "- well", "@home", "'=quoted", "'tis fine")[place]
        Sentence.objects.filter(pk=row.pk).update(text=row.text)
    out = [one["English"] for one in lines_of(taken(author, "sentences"))]
    assert {"'=1+1", "'+39 is Italy.", "'- well", "'@home", "''=quoted", "'tis fine"} <= set(out)
    book = openpyxl.load_workbook(io.BytesIO(taken(author, "sentences", "xlsx")))
    assert all(cell.data_type != "f" for row in book.active.iter_rows() for cell in row)
    for form in ("csv", "xlsx"):
        data = taken(author, "sentences", form)
        assert set(counts(brought(author, "sentences", data, f"a.{form}"))) == {"same"}


def test_a_csv_begins_so_that_excel_knows_its_letters(author: Client) -> None:
    assert taken(author, "sentences").startswith(b"\xef\xbb\xbf")


def test_a_csv_with_semicolons_is_read(author: Client) -> None:
    lines = lines_of(taken(author, "likeliness"))
    line(lines, "Tea")["EN"] = "0,85"
    answer = brought(author, "likeliness", csv_of(lines, ";"))
    assert counts(answer) == {"changed": 1, "same": len(lines) - 1}


# Filters.


def test_a_branch_is_taken_out_alone(author: Client) -> None:
    keys = [one["key"] for one in lines_of(taken(author, "sentences", branch="Drink"))]
    assert keys == ["Drink.q1", "Drink.p1", "Drink.g1", "GreenTea.c1"]


def test_a_pool_is_taken_out_alone(author: Client) -> None:
    lines = lines_of(taken(author, "sentences", branch="pool:start"))
    assert [one["topic or pool"] for one in lines] == ["start"]


def test_one_language_is_taken_out_and_the_others_stay(author: Client) -> None:
    lines = lines_of(taken(author, "sentences", branch="Drink", language="it"))
    assert "Italian" in lines[0]
    assert "English" not in lines[0]
    line(lines, "Drink.q1")["Italian"] = "Bevi volentieri $hasName?"
    answer = brought(author, "sentences", csv_of(lines))
    assert counts(answer)["changed"] == 1
    saved(author, "sentences", answer)
    texts = dict(Sentence.objects.filter(frame__key="Drink.q1").values_list("language", "text"))
    assert texts["it"] == "Bevi volentieri $hasName?"
    assert texts["en"] == "Do you like $hasName?"


def test_a_family_of_intents_is_taken_out_alone(author: Client) -> None:
    Intent.objects.create(key="rest", family="body")
    Trigger.objects.create(intent=Intent.objects.get(key="rest"), language="en", text="rest now")
    lines = lines_of(taken(author, "triggers", family="body"))
    assert [one["intent"] for one in lines] == ["rest"]


# Sentences.


def test_a_changed_sentence_is_shown_with_its_words_marked_and_saved(author: Client) -> None:
    def change(lines: Lines) -> None:
        line(lines, "Drink.q1")["English"] = "Do you enjoy $hasName?"

    answer = changed(author, "sentences", change)
    page = answer.content.decode()
    assert "<del>like</del><ins>enjoy</ins>" in page
    assert Sentence.objects.filter(text="Do you enjoy $hasName?").count() == 0
    done = saved(author, "sentences", answer)
    assert "1 row is saved" in text(done)
    assert Sentence.objects.get(frame__key="Drink.q1", language="en").text.startswith(
        "Do you enjoy"
    )


def test_a_new_sentence_gets_the_next_free_name(author: Client) -> None:
    def add(lines: Lines) -> None:
        new = {"topic or pool": "Drink", "type": "yes/no question", "cultures": "jp, en"}
        lines.append({"key": "", **new, "English": "Is $hasName good?", "Italian": "Ti va?"})

    answer = changed(author, "sentences", add)
    assert counts(answer)["new"] == 1
    saved(author, "sentences", answer)
    frame = Frame.objects.get(key="Drink.q2")
    assert {one.code for one in frame.only.all()} == {"EN", "JP"}
    assert {one.language for one in frame.sentences.all()} == {"en", "it"}
    assert frame.position == max(Frame.objects.values_list("position", flat=True))


def test_saving_the_same_preview_twice_adds_nothing_twice(author: Client) -> None:
    new = {"key": "", "topic or pool": "Tea", "type": "c", "English": "Tea warms."}
    answer = brought(author, "sentences", csv_of([new]))
    saved(author, "sentences", answer)
    again = saved(author, "sentences", answer)
    assert again.status_code == 409
    assert Frame.objects.filter(topic__key="Tea").count() == 1


def test_a_row_is_deleted_only_where_the_sheet_says_yes(author: Client) -> None:
    def change(lines: Lines) -> None:
        line(lines, "GreenTea.c1")["delete"] = "sì"
        lines.remove(line(lines, "Drink.q1"))

    answer = changed(author, "sentences", change)
    assert counts(answer)["deleted"] == 1
    saved(author, "sentences", answer)
    assert not Frame.objects.filter(key="GreenTea.c1").exists()
    assert Frame.objects.filter(key="Drink.q1").exists()


def test_an_emptied_cell_takes_the_sentence_of_that_language_away(author: Client) -> None:
    answer = changed(author, "sentences", lambda lines: line(lines, "Drink.q1").update(Japanese=""))
    assert "<del>" in answer.content.decode()
    saved(author, "sentences", answer)
    assert not Sentence.objects.filter(frame__key="Drink.q1", language="ja").exists()


def test_mistakes_are_told_by_line_and_column_and_do_not_hide_the_rest(author: Client) -> None:
    rows = [
        {"key": "", "topic or pool": "Te", "type": "q", "English": "Do you?", "cultures": ""},
        {"key": "", "topic or pool": "Tea", "type": "z", "English": "Do you?"},
        {"key": "", "topic or pool": "Tea", "type": "q", "English": "A $cup of tea?"},
        {"key": "", "topic or pool": "Tea", "type": "q", "English": "{is|are"},
        {"key": "", "topic or pool": "Tea", "type": "q", "English": "Well?", "cultures": "XX"},
        {"key": "Drink.q1", "English": "Do you enjoy $hasName?"},
        {"key": "", "topic or pool": "Tea", "type": "q", "English": ""},
        {"key": "", "topic or pool": "start", "type": "", "English": "Hello $hasName."},
    ]
    columns = ["key", "topic or pool", "type", "cultures", "English"]
    data = csv_of([{name: row.get(name, "") for name in columns} for row in rows])
    answer = brought(author, "sentences", data)
    found = {(number, column): message for number, column, message in mistakes(answer)}
    assert found[2, "topic or pool"] == "There is no topic or pool “Te”. Did you mean Tea?"
    assert "There is no type “z”" in found[3, "type"]
    assert "$cup" in found[4, "English"]
    assert "position 2" in found[4, "English"]
    assert "position 0" in found[5, "English"]
    assert "There is no culture XX" in found[6, "cultures"]
    assert "one language at least" in found[8, ""]
    assert "does not know $hasName" in found[9, "English"]
    # Line 7 keeps the topic and type that the sheet leaves empty: that is told too.
    assert counts(answer)["wrong"] == 8


def test_good_rows_are_saved_beside_bad_ones(author: Client) -> None:
    rows = [
        {"key": "Drink.q1", "English": "Do you enjoy $hasName?"},
        {"key": "Drink.p1", "English": "Lovely $nothing."},
    ]
    answer = brought(author, "sentences", csv_of(rows))
    assert counts(answer) == {"changed": 1, "wrong": 1}
    saved(author, "sentences", answer)
    assert Sentence.objects.filter(text="Do you enjoy $hasName?").exists()
    assert not Sentence.objects.filter(text__contains="$nothing").exists()


def test_a_sentence_that_a_topic_below_cannot_say_is_refused(author: Client) -> None:
    row = {"key": "Drink.q1", "English": "A $unit $hasName.bare of $place?"}
    answer = brought(author, "sentences", csv_of([row]))
    [(_line, column, message)] = mistakes(answer)
    assert column == "English"
    assert "$place" in message


def test_a_key_that_stands_twice_is_refused(author: Client) -> None:
    rows = [{"key": "Drink.q1", "English": f"Do you {one} $hasName?"} for one in ("a", "b")]
    answer = brought(author, "sentences", csv_of(rows))
    assert mistakes(answer) == [
        (3, "key", "Drink.q1 stands in line 2 already. Remove one of the two.")
    ]


def test_a_sentence_keeps_its_topic(author: Client) -> None:
    row = {"key": "Drink.q1", "topic or pool": "Tea"}
    assert "keeps its topic" in mistakes(brought(author, "sentences", csv_of([row])))[0][2]


# Topics.


def test_a_topic_and_one_below_it_are_added_in_any_order(author: Client) -> None:
    rows = [
        {"name in the ontology": "Sencha", "is a": "LooseTea", "English name": "sencha"},
        {"name in the ontology": "LooseTea", "is a": "Tea", "English name": "loose tea"},
    ]
    for row in rows:
        row |= {"English forms": "count=no", "English keywords": "loose / tea", "home": "jp"}
    answer = brought(author, "topics", csv_of(rows))
    assert counts(answer) == {"new": 2}
    saved(author, "topics", answer)
    sencha = Topic.objects.get(key="Sencha")
    assert sencha.parent
    assert sencha.parent.parent
    assert sencha.parent.parent.key == "Tea"
    assert sencha.home
    assert sencha.home.code == "JP"
    assert sencha.names.get().fields == {"count": "no"}
    keywords = KeywordSet.objects.get(topic=sencha)
    assert (keywords.first, keywords.second) == ("loose", "tea")
    assert sencha.instances.count() == 2


def test_topics_are_refused_in_plain_words(author: Client) -> None:
    rows = [
        {"name in the ontology": "Mocha", "is a": "Drnk"},
        {"name in the ontology": "Not a name", "is a": "Drink"},
        {"name in the ontology": "Drink", "is a": "GreenTea"},
        {
            "name in the ontology": "Latte",
            "is a": "Drink",
            "Italian name": "latte",
            "Italian forms": "g=x",
        },
        {"name in the ontology": "Chai", "is a": "Drink", "Italian forms": "masculine"},
        {"name in the ontology": "Ice", "is a": "Mocha"},
        {"name in the ontology": "Milk", "is a": ""},
    ]
    columns = ["name in the ontology", "is a", "Italian name", "Italian forms"]
    data = csv_of([{name: row.get(name, "") for name in columns} for row in rows])
    found = {(n, c): m for n, c, m in mistakes(brought(author, "topics", data))}
    assert found[2, "is a"].endswith("Did you mean Drink?")
    assert "one word" in found[3, "name in the ontology"]
    assert "below itself" in found[4, "is a"]
    assert (5, "Italian forms") in found
    assert "masculine" in found[6, "Italian forms"]
    assert "mistake in its own line" in found[7, "is a"]
    assert "Topic for a branch" in found[8, "is a"]


def test_a_topic_with_others_below_it_is_not_deleted_alone(author: Client) -> None:
    rows = [{"name in the ontology": "Tea", "delete": "yes"}]
    assert "GreenTea stands below it" in mistakes(brought(author, "topics", csv_of(rows)))[0][2]
    rows.append({"name in the ontology": "GreenTea", "delete": "yes"})
    answer = brought(author, "topics", csv_of(rows))
    assert counts(answer) == {"deleted": 2}
    assert "Its sentences are deleted too: 1." in text(answer)
    saved(author, "topics", answer)
    assert not Topic.objects.filter(key__in=["Tea", "GreenTea"]).exists()


def test_names_and_keywords_are_changed_and_taken_away(author: Client) -> None:
    def change(lines: Lines) -> None:
        line(lines, "Tea")["English name"] = "black tea"
        line(lines, "Tea")["Japanese keywords"] = ""

    saved(author, "topics", changed(author, "topics", change))
    assert TopicName.objects.get(topic__key="Tea", language="en").name == "black tea"
    assert TopicName.objects.get(topic__key="Tea", language="en").fields == {"count": "no"}
    assert not KeywordSet.objects.filter(topic__key="Tea", language="ja").exists()


# Likeliness.


def test_likeliness_is_changed_with_a_comma_or_a_point(author: Client) -> None:
    def change(lines: Lines) -> None:
        line(lines, "Tea").update(EN="0,85", JP=".9")

    saved(author, "likeliness", changed(author, "likeliness", change))
    found = TopicInstance.objects.filter(topic__key="Tea").values_list(
        "culture__code", "likeliness"
    )
    assert {code: float(value) for code, value in found} == {"EN": 0.85, "JP": 0.9}


@pytest.mark.parametrize("wrong", ["1.2", "-0.1", "much", "NaN", "", "0.12345"])
def test_a_likeliness_outside_0_to_1_is_refused(author: Client, wrong: str) -> None:
    answer = brought(author, "likeliness", csv_of([{"topic": "Tea", "EN": wrong}]))
    assert [(number, column) for number, column, _ in mistakes(answer)] == [(2, "EN")]


def test_the_likeliness_of_a_topic_that_does_not_exist_is_refused(author: Client) -> None:
    answer = brought(author, "likeliness", csv_of([{"topic": "Te", "EN": "0.5"}]))
    assert mistakes(answer) == [(2, "topic", "There is no topic “Te”. Did you mean Tea?")]


# Intents.


def test_a_trigger_is_changed_in_its_place(author: Client) -> None:
    def change(lines: Lines) -> None:
        lines[0]["trigger"] = "(play|put on|start) [the song] {title}"

    saved(author, "triggers", changed(author, "triggers", change))
    assert Trigger.objects.filter(language="en").values_list("text", flat=True).get() == (
        "(play|put on|start) [the song] {title}"
    )


def test_triggers_are_added_and_refused_with_the_place(author: Client) -> None:
    rows = [
        {"intent": "playsong", "language": "Italian", "trigger": "suona {title}"},
        {"intent": "playsong", "language": "en", "trigger": "play (it {title}"},
        {"intent": "playsong", "language": "en", "trigger": "play {what}"},
        {"intent": "playsng", "language": "en", "trigger": "play"},
        {"intent": "playsong", "language": "it", "trigger": "suona {title}"},
        {"intent": "playsong", "language": "xx", "trigger": "la"},
    ]
    answer = brought(author, "triggers", csv_of(rows))
    found = {number: (column, message) for number, column, message in mistakes(answer)}
    assert counts(answer) == {"new": 1, "wrong": 5}
    assert found[3][0] == "trigger"
    assert "letter" in found[3][1]
    assert "what" in found[4][1]
    assert found[5][1].endswith("Did you mean playsong?")
    assert "line 2 already" in found[6][1]
    assert "Use: en, it, ja" in found[7][1]
    saved(author, "triggers", answer)
    texts = Trigger.objects.filter(language="it").values_list("text", "position")
    assert list(texts) == [("metti la canzone {title}", 0), ("suona {title}", 1)]


def test_a_trigger_that_somebody_changed_meanwhile_is_not_overwritten(author: Client) -> None:
    lines = lines_of(taken(author, "triggers"))
    Trigger.objects.filter(language="en").update(text="play {title}")
    lines[0]["trigger"] = "put on {title}"
    answer = brought(author, "triggers", csv_of(lines))
    assert "not there any more" in mistakes(answer)[0][2]


def test_plan_sentences_and_tests_are_changed(author: Client) -> None:
    def change(lines: Lines) -> None:
        lines[0].update(sentence="Here is {title}.", cultures="JP")

    saved(author, "plan_sentences", changed(author, "plan_sentences", change))
    assert PlanSentence.objects.filter(text="Here is {title}.", only="JP").exists()
    rows = [
        {
            "intent": "playsong",
            "language": "en",
            "sentence": "Play Volare",
            "expected": "title=Volare",
        },
        {"intent": "playsong", "language": "en", "sentence": "I like songs", "expected": "no"},
    ]
    saved(author, "tests", brought(author, "tests", csv_of(rows)))
    found = dict(IntentTest.objects.values_list("sentence", "parameters"))
    assert found["Play Volare"] == {"title": "Volare"}
    assert found["I like songs"] is None
    row = {"intent": "playsong", "language": "en", "sentence": "Here {is}"}
    assert "{is}" in mistakes(brought(author, "plan_sentences", csv_of([row])))[0][2]


# Nothing is saved on what is not there any more.


def test_a_draft_that_changed_meanwhile_is_shown_again(author: Client) -> None:
    answer = brought(
        author, "sentences", csv_of([{"key": "Drink.q1", "English": "Do you $hasName?"}])
    )
    Sentence.objects.filter(frame__key="Drink.q1", language="en").update(text="Who likes $hasName?")
    again = saved(author, "sentences", answer)
    assert again.status_code == 409
    assert "The draft has changed meanwhile" in text(again)
    assert "likes" in text(again)
    saved(author, "sentences", again)
    assert Sentence.objects.filter(text="Do you $hasName?").exists()


def test_a_change_of_other_rows_does_not_matter(author: Client) -> None:
    answer = brought(
        author, "sentences", csv_of([{"key": "Drink.q1", "English": "Do you $hasName?"}])
    )
    other = Sentence.objects.get(frame__key="Drink.p1", language="en")
    other.text = "Fine."
    other.save()
    assert "1 row is saved" in text(saved(author, "sentences", answer))


def test_a_preview_changes_nothing_not_even_the_draft_version(author: Client) -> None:
    before = draft_version()
    changed(author, "sentences", lambda lines: line(lines, "Drink.q1").update(English="Well?"))
    assert draft_version() == before


@pytest.mark.parametrize("sealed", ["", "abc", "a:b:c"])
def test_a_damaged_preview_saves_nothing(author: Client, sealed: str) -> None:
    answer = author.post("/admin/sheets/sentences/save/", {"sealed": sealed})
    assert answer.status_code == 400
    assert "Bring the sheet again" in text(answer)


def test_nobody_saves_the_preview_of_somebody_else(author: Client) -> None:
    answer = brought(author, "sentences", csv_of([{"key": "Drink.q1", "English": "Well?"}]))
    other = logged_in(PUBLISHER)
    assert saved(other, "sentences", answer).status_code == 400
    assert not Sentence.objects.filter(text="Well?").exists()


def test_what_a_sheet_changes_stands_in_the_history(author: Client) -> None:
    saved(
        author,
        "sentences",
        brought(author, "sentences", csv_of([{"key": "Drink.q1", "English": "Well?"}])),
    )
    record = Sentence.history.get(place="Drink.q1")
    assert record.history_user.username == AUTHOR
    assert record.change["fields"][0][1:3] == ["Do you like $hasName?", "Well?"]


# Files that are none.


def read(name: str, data: bytes) -> str:
    """Return why a file is refused."""
    with pytest.raises(UnreadableError) as error:
        read_table(name, data, ["key", "English"], "Sentences")
    return str(error.value)


def test_a_wrong_encoding_is_told_what_to_save_as() -> None:
    data = "key,Italian\nTea.q1,Ti piace il tè?\n".encode("cp1252")
    assert read("a.csv", data) == "The letters cannot be read. Save it as CSV UTF-8 or as XLSX."


def test_macros_and_other_programs_files_are_refused() -> None:
    file = io.BytesIO(xlsx_of(["key"], ["a"]))
    with zipfile.ZipFile(file, "a") as archive:
        archive.writestr("xl/vbaProject.bin", b"x")
    assert "macros" in read("a.xlsx", file.getvalue())
    assert "macros" in read("a.xlsm", xlsx_of(["key"]))
    assert "old or locked" in read("a.xls", b"\xd0\xcf\x11\xe0rest")
    assert "no .xlsx" in read("a.xlsx", b"key\nTea.q1\n")
    assert "damaged" in read("a.xlsx", xlsx_of(["key"])[:-40])


def test_a_file_that_unpacks_without_end_is_refused_unread(settings: Settings) -> None:
    settings.CAIR_SHEET_INFLATED = 1_000_000
    file = io.BytesIO(xlsx_of(["key"], ["a"]))
    with zipfile.ZipFile(file, "a", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("xl/worksheets/sheet2.xml", b"0" * 5_000_000)
    assert len(file.getvalue()) < 100_000
    assert "unpacks to far too much" in read("a.xlsx", file.getvalue())


def test_entities_that_grow_without_end_are_refused() -> None:
    bomb = b'<?xml version="1.0"?><!DOCTYPE a [<!ENTITY a "aaaaaaaaaa">'
    for place in range(20):
        bomb += b'<!ENTITY %c "%s">' % (98 + place, b"&%c;" % (97 + place) * 10)
    bomb += b"]><workbook>&u;</workbook>"
    file = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(xlsx_of(["key"]))) as old, zipfile.ZipFile(file, "w") as new:
        for part in old.infolist():
            new.writestr(part, bomb if part.filename == "xl/workbook.xml" else old.read(part))
    assert "damaged" in read("a.xlsx", file.getvalue())


def test_too_many_rows_are_refused_with_what_to_do(settings: Settings) -> None:
    settings.CAIR_SHEET_ROWS = 3
    rows = "".join(f"Tea.q{number}\n" for number in range(4))
    assert "more than 3 rows" in read("a.csv", f"key\n{rows}".encode())
    assert "blank lines" in read("a.csv", b"key\n" + b"\n" * 30_000 + b"a\n")


def test_a_file_that_is_too_large_is_refused(author: Client, settings: Settings) -> None:
    settings.CAIR_SHEET_BYTES = 1000
    answer = brought(author, "sentences", b"x" * 2000)
    assert answer.status_code == 400
    assert "Bring a part of it" in text(answer)


def test_formulas_and_dates_are_refused_in_their_cell(author: Client) -> None:
    data = xlsx_of(["key", "English"], ["Drink.q1", "=1+1"], ["Drink.p1", "Fine $hasName."])
    answer = brought(author, "sentences", data, "a.xlsx")
    assert [one[:2] for one in mistakes(answer)] == [(2, "English")]
    assert "formula" in mistakes(answer)[0][2]
    assert counts(answer)["changed"] == 1
    answer = brought(author, "sentences", b"key,English\nDrink.q1,=1+1\n")
    assert "formula" in mistakes(answer)[0][2]


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"", "empty"),
        (b"English\nHello\n", "column “key” is missing"),
        (b"key,Englisch\nDrink.q1,x\n", "Did you mean English?"),
        (b"key,English,English\na,b,c\n", "is there twice"),
        (b'key,English\nDrink.q1,"never closed\n', "Line 2"),
        (b"key\0,English\n", "no text"),
    ],
)
def test_sheets_that_cannot_be_read_say_why(author: Client, data: bytes, words: str) -> None:
    answer = brought(author, "sentences", data)
    assert answer.status_code == 400
    assert words in text(answer)


# Who may.


def test_researchers_take_sheets_out_but_bring_none_in() -> None:
    client = logged_in(RESEARCHER)
    assert lines_of(taken(client, "sentences"))
    page = client.get("/admin/sheets/sentences/")
    assert "Bringing them in is for authors" in text(page)
    assert 'type="file"' not in page.content.decode()
    assert brought(client, "sentences", b"key\n").status_code == 403
    assert client.post("/admin/sheets/sentences/save/", {}).status_code == 403


@pytest.mark.parametrize("role", [AUTHOR, PUBLISHER, ADMINISTRATOR])
def test_those_who_write_bring_sheets_in(role: str) -> None:
    page = logged_in(role).get("/admin/sheets/topics/").content.decode()
    assert 'type="file"' in page


def test_whoever_may_not_delete_is_told_so(author: Client) -> None:
    from django.contrib.auth.models import Permission, User

    user = User.objects.create_user("careful", is_staff=True)
    names = ["export_content", "change_topic", "change_frame", "change_sentence"]
    user.user_permissions.set(Permission.objects.filter(codename__in=names))
    client = Client()
    client.force_login(user)
    row = {"key": "Drink.q1", "delete": "yes"}
    answer = brought(client, "sentences", csv_of([row]))
    assert mistakes(answer) == [(2, "", "You may not delete rows here.")]


def test_nobody_without_a_role_sees_sheets() -> None:
    client = logged_in("")
    for path in ("", "sentences/", "sentences/file/"):
        assert client.get(f"/admin/sheets/{path}").status_code == 403


@pytest.mark.parametrize("kind", KINDS)
def test_the_pages_ask_little_of_the_database(
    author: Client, kind: str, django_assert_max_num_queries: DjangoAssertNumQueries
) -> None:
    with django_assert_max_num_queries(25):
        author.get(f"/admin/sheets/{kind}/")
    with django_assert_max_num_queries(25):
        data = taken(author, kind)
    lines = lines_of(data)
    for one in lines:
        one.update(
            {name: f"{words}!" for name, words in one.items() if name in ("English", "note")}
        )
    with django_assert_max_num_queries(45):
        brought(author, kind, csv_of(lines))


def test_a_kind_that_does_not_exist_is_not_found(author: Client) -> None:
    assert author.get("/admin/sheets/nothing/").status_code == 404
    assert author.get("/admin/sheets/sentences/file/", {"form": "exe"}).status_code == 404
