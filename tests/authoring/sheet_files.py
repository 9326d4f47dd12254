"""An expert with a spreadsheet: takes one out, changes cells, brings it back, saves."""

import csv
import io
import re
from collections.abc import Callable
from html import unescape

import openpyxl
from django.core.files.uploadedfile import SimpleUploadedFile
from django.http import HttpResponse
from django.test import Client

Lines = list[dict[str, str]]


def taken(client: Client, kind: str, form: str = "csv", **chosen: str) -> bytes:
    """Return the file of a sheet."""
    answer = client.get(f"/admin/sheets/{kind}/file/", {"form": form, **chosen})
    assert answer.status_code == 200, answer.content[:300]
    return bytes(answer.content)


def lines_of(data: bytes) -> Lines:
    """Return the lines of a CSV by column."""
    return list(csv.DictReader(io.StringIO(data.decode("utf-8-sig"), newline="")))


def csv_of(lines: Lines, delimiter: str = ",") -> bytes:
    """Return lines as a CSV with the columns of the first."""
    file = io.StringIO(newline="")
    writer = csv.DictWriter(file, list(lines[0]), delimiter=delimiter, restval="")
    writer.writeheader()
    writer.writerows(lines)
    return file.getvalue().encode("utf-8-sig")


def xlsx_of(*rows: list[object]) -> bytes:
    """Return rows as an .xlsx, as a spreadsheet program writes it."""
    book = openpyxl.Workbook()
    for row in rows:
        book.active.append(row)
    file = io.BytesIO()
    book.save(file)
    return file.getvalue()


def brought(client: Client, kind: str, data: bytes, name: str = "sheet.csv") -> HttpResponse:
    """Bring a file and return the preview."""
    file = SimpleUploadedFile(name, data)
    return client.post(f"/admin/sheets/{kind}/preview/", {"file": file})


def text(answer: HttpResponse) -> str:
    """Return the page as a person reads it: without tags, blanks joined."""
    page = answer.content.decode()
    main = page[page.find('id="content"') :] + page[page.find("messagelist") :]
    return " ".join(unescape(re.sub(r"<[^>]*>", " ", main)).split())


def saved(client: Client, kind: str, preview: HttpResponse) -> HttpResponse:
    """Press "Save these changes" under a preview."""
    sealed = preview.context["sealed"]
    return client.post(f"/admin/sheets/{kind}/save/", {"sealed": sealed}, follow=True)


def changed(
    client: Client, kind: str, change: Callable[[Lines], object], **chosen: str
) -> HttpResponse:
    """Take a sheet out, change its lines, bring it back; return the preview."""
    lines = lines_of(taken(client, kind, **chosen))
    change(lines)
    return brought(client, kind, csv_of(lines))


def line(lines: Lines, name: str) -> dict[str, str]:
    """Return the line whose first cell has this name."""
    return next(one for one in lines if next(iter(one.values())) == name)
