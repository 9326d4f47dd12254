"""Japanese names: `$hasName` is the polite お寿司, `.bare` the plain 寿司, `.kana` its reading."""

from collections.abc import Mapping

from languages.language import NameForms
from languages.name_fields import check_fields

FORMS = frozenset({"bare", "kana"})
FIELDS = frozenset({"name", "polite", "kana"})


def name_forms(fields: Mapping[str, str]) -> NameForms:
    """Return the forms of a Japanese name; without `kana` the reading is the name itself."""
    check_fields(fields, FIELDS)
    name = fields["name"]
    return NameForms(
        {"": fields.get("polite", name), "bare": name, "kana": fields.get("kana", name)}
    )
