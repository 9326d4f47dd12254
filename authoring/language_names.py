"""Names of languages, in the language of the page."""

from django.utils.translation import get_language_info


def language_name(code: str) -> str:
    """Return the name of a language in the language of the page; the code where it has none."""
    try:
        return str(get_language_info(code)["name_translated"]) if code else ""
    except KeyError:
        return code
