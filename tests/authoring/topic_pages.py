"""What the tests of the topic page share."""

from django.contrib.auth.models import Group, User
from django.test import Client
from django.urls import reverse

from authoring.topic_page.panel import Panel, read_panel
from authoring.topic_page.shape import read_shape
from dialogue import models


def topic(key: str) -> models.Topic:
    return models.Topic.objects.get(key=key)


def page(key: str) -> str:
    return reverse("admin:dialogue_topic_change", args=[topic(key).pk])


def panel(key: str, culture: str = "EN", language: str = "en") -> Panel:
    return read_panel(read_shape(), topic(key).pk, culture, language)


def texts(shown: Panel, letter: str) -> list[str]:
    section = next(one for one in shown.sections if one.section.letter == letter)
    return [one.said.text for group in section.groups for one in group.sentences]


def member(role: str) -> Client:
    user = User.objects.create_user(role, is_staff=True)
    if role != "nobody":
        user.groups.add(Group.objects.get(name=role))
    client = Client()
    client.force_login(user)
    return client
