"""The charts of the dashboard, each drawn from the same numbers as the table beside it."""

from django.utils.translation import gettext as _

from authoring.coverage.charts import Chart, Series, columns, grouped, stacked
from authoring.coverage.coverage import STEPS, Coverage
from authoring.coverage.coverage_tables import called, culture_name
from authoring.topic_page.words import KINDS, LANGUAGE_NAMES
from languages.known import LANGUAGES


def kinds_chart(found: Coverage, language: str) -> Chart:
    """Return the sentences of each branch by kind, in one language."""
    tones = [(kind.letter, str(kind.name)) for kind in KINDS.values()]
    rows = [
        Series(called(row), [row.said[language, letter] for letter in KINDS])
        for row in sorted(found.branches, key=lambda row: -row.sentences(language))
    ]
    title = _("Sentences of each branch by kind, in %s") % LANGUAGE_NAMES[language]
    told = _("A bar for each branch; the table “Kinds of sentence” holds the same numbers.")
    return stacked("chart-kinds", (title, told), tones, rows)


def liking_charts(found: Coverage) -> list[Chart]:
    """Return the spread of likeliness in each culture, all on one scale."""
    steps = range(STEPS)
    counts = {
        culture.number: [found.topics_liking(culture.number, step) for step in steps]
        for culture in found.cultures
    }
    most = max((max(values) for values in counts.values()), default=0)
    told = _("How many topics have which likeliness; the table holds the same numbers.")
    return [
        columns(
            f"chart-liking-{culture.number}",
            (culture_name(culture), told),
            [Series(f".{step}", (counts[culture.number][step],)) for step in steps],
            most=most,
            tone=place % 4,
        )
        for place, culture in enumerate(found.cultures)
    ]


def depth_chart(found: Coverage) -> Chart:
    """Return how many topics stand how deep."""
    rows = [Series(str(depth), (count,)) for depth, count in sorted(found.depths.items())]
    words = (_("How deep the tree is"), _("Topics by the number of steps below the root."))
    return columns("chart-depth", words, rows, most=max(found.depths.values(), default=0))


def family_chart(found: Coverage) -> Chart:
    """Return the triggers of each family of intents by language."""
    tones = [(code, str(LANGUAGE_NAMES[code])) for code in LANGUAGES]
    rows = [
        Series(
            f"{family.name or _('(no family)')} ({family.intents})",
            [family.triggers[code] for code in LANGUAGES],
        )
        for family in found.families
    ]
    title = _("Ways to say it, by family of intents")
    told = _("Trigger sentences in each language; behind the name the number of intents.")
    return grouped("chart-families", (title, told), tones, rows)
