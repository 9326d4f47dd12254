# -*- coding: utf-8 -*-
"""The few words the tablet shows while the robot does something."""

from __future__ import unicode_literals

#: action -> (English, Italian, Japanese)
LABELS = {
    "alert": ("Calling for help", "Chiamo aiuto", "助けを呼んでいます"),
    "attention": ("Hello there!", "Sono qui!", "こちらです！"),
    "brightness": ("My screen", "Il mio schermo", "画面の明るさ"),
    "call": ("Calling", "Sto chiamando", "電話をかけています"),
    "dance": ("Dancing", "Ballo", "ダンス"),
    "date": ("Today", "Oggi", "今日"),
    "dictionary": ("Dictionary", "Dizionario", "辞書"),
    "followme": ("I am following you", "Ti seguo", "ついて行きます"),
    "forgetmap": ("My map", "La mia mappa", "地図"),
    "go": ("I am on my way", "Sono in cammino", "進んでいます"),
    "goto": ("I am on my way", "Sono in cammino", "移動しています"),
    "handshake": ("Pleased to meet you", "Piacere!", "握手"),
    "hello": ("Hello!", "Ciao!", "こんにちは！"),
    "hug": ("A hug for you", "Un abbraccio per te", "ハグ"),
    "konnichiwa": ("Konnichiwa!", "Konnichiwa!", "こんにちは！"),
    "learnplace": ("A new place", "Un posto nuovo", "新しい場所"),
    "light": ("The light", "La luce", "明かり"),
    "move": ("One step", "Un passo", "一歩"),
    "namaste": ("Namaste!", "Namasté!", "ナマステ！"),
    "news": ("The news", "Le notizie", "ニュース"),
    "photo": ("Smile!", "Sorridi!", "はい、チーズ！"),
    "playkaraoke": ("Karaoke", "Karaoke", "カラオケ"),
    "playmovie": ("A film", "Un film", "映画"),
    "playsong": ("Music", "Musica", "音楽"),
    "quiz": ("A quiz", "Un quiz", "クイズ"),
    "registration": ("Pleased to meet you", "Piacere di conoscerti", "はじめまして"),
    "rest": ("I am charging", "Mi ricarico", "充電します"),
    "setposition": ("Where I am", "Dove sono", "今いる場所"),
    "showexercise": ("Exercises", "Esercizi", "体操"),
    "showinstructions": ("How to do it", "Come si fa", "やり方"),
    "time": ("The time", "L'ora", "時刻"),
    "timer": ("A timer", "Un timer", "タイマー"),
    "alarm": ("An alarm", "Una sveglia", "アラーム"),
    "reminder": ("A reminder", "Un promemoria", "お知らせ"),
    "translate": ("Translation", "Traduzione", "翻訳"),
    "voicespeed": ("My voice", "La mia voce", "話す速さ"),
    "volume": ("My voice", "La mia voce", "音量"),
    "wakeup": ("Good morning!", "Buongiorno!", "おはようございます"),
    "weather": ("The weather", "Che tempo fa", "天気"),
    "wikisearch": ("I am looking it up", "Sto cercando", "調べています"),
}
PRIVACY = (
    "I am not looking. Touch my head.",
    "Non guardo. Toccami la testa.",
    "見ていません。頭に触れてください。",
)


def label(action, language):
    """Return the words for an action, "" for one nobody has named."""
    return _of(LABELS.get(action, ("", "", "")), language)


def privacy_label(language):
    """Return the words of the privacy mode."""
    return _of(PRIVACY, language)


def _of(three, language):
    return three[("en", "it", "ja").index(language)]
