# -*- coding: utf-8 -*-
"""What the robot itself says, in each language: the server knows nothing of its legs and places."""

from __future__ import unicode_literals

import re

#: {braces} are filled in. Kind, short, to be spoken aloud.
TEXTS = {
    "i_am": {
        "en": "I am {robot}.",
        "it": "Io sono {robot}.",
        "ja": "私は{robot}です。",
    },
    "wait": {
        "en": "Just a moment, please. I am collecting my thoughts, and then I will answer you.",
        "it": "Solo un momento, per favore. Raccolgo le idee e poi ti rispondo.",
        "ja": "少しだけお待ちくださいね。考えをまとめたら、お返事します。",
    },
    "trouble": {
        "en": "I am sorry, something is wrong with me. Please tell whoever looks after me.",
        "it": "Mi dispiace, ho un problema. Per favore, dillo a chi si occupa di me.",
        "ja": "すみません、調子が良くないようです。私の担当の方に伝えていただけますか。",
    },
    "not_learned": {
        "en": "I am sorry, I have not learned how to do that yet.",
        "it": "Mi dispiace, questo non l'ho ancora imparato.",
        "ja": "ごめんなさい、それはまだ覚えていないんです。",
    },
    "not_now": {
        "en": "I am sorry, that did not work just now. Shall we try again a little later?",
        "it": "Mi dispiace, adesso non ci sono riuscito. Riproviamo più tardi?",
        "ja": "ごめんなさい、今はうまくできませんでした。また後で試してみましょう。",
    },
    "paused": {
        "en": "I will be quiet now. Touch my head when you would like to talk again.",
        "it": "Adesso sto in silenzio. Toccami la testa quando vuoi parlare ancora.",
        "ja": "では、静かにしていますね。またお話ししたくなったら、頭に触れてください。",
    },
    "resumed": {
        "en": "Here I am. I am listening.",
        "it": "Eccomi. Ti ascolto.",
        "ja": "はい、お話をうかがいます。",
    },
    "never_mind": {
        "en": "Never mind, then.",
        "it": "Va bene, non importa.",
        "ja": "では、また今度にしましょう。",
    },
    "ask_direction": {
        "en": "Which way shall I go: forward, back, left or right?",
        "it": "Da che parte vado: avanti, indietro, a sinistra o a destra?",
        "ja": "前、後ろ、左、右の、どちらへ行きましょうか？",
    },
    "ask_place": {
        "en": "What is this place called?",
        "it": "Come si chiama questo posto?",
        "ja": "ここは何という場所ですか？",
    },
    "ask_where": {
        "en": "Where shall I go?",
        "it": "Dove vado?",
        "ja": "どこへ行きましょうか？",
    },
    "ask_name": {
        "en": "I would love to get to know you. What is your name?",
        "it": "Mi fa tanto piacere conoscerti. Come ti chiami?",
        "ja": "お知り合いになれてうれしいです。お名前は何とおっしゃいますか？",
    },
    "ask_what": {
        "en": "What would you like me to look for?",
        "it": "Che cosa vuoi che cerchi?",
        "ja": "何を調べましょうか？",
    },
    "ask_translate": {
        "en": "What would you like me to translate?",
        "it": "Che cosa vuoi che traduca?",
        "ja": "何を訳しましょうか？",
    },
    "ask_language": {
        "en": "Into which language?",
        "it": "In quale lingua?",
        "ja": "何語に訳しましょうか？",
    },
    "ask_whom": {
        "en": "Whom would you like to call?",
        "it": "Chi vuoi chiamare?",
        "ja": "どなたに電話しましょうか？",
    },
    "ask_light": {
        "en": "Shall I switch the light on or off?",
        "it": "Devo accendere o spegnere la luce?",
        "ja": "明かりをつけますか、それとも消しますか？",
    },
    "ask_brightness": {
        "en": "Would you like my screen brighter or darker?",
        "it": "Vuoi lo schermo più luminoso o più scuro?",
        "ja": "画面を明るくしますか、それとも暗くしますか？",
    },
    "ask_seconds": {
        "en": "For how many minutes?",
        "it": "Per quanti minuti?",
        "ja": "何分にしましょうか？",
    },
    "ask_time": {
        "en": "At what time? Tell me the hour and the minutes.",
        "it": "A che ora? Dimmi l'ora e i minuti.",
        "ja": "何時何分にしましょうか？",
    },
    "ask_title": {
        "en": "I have {titles}. Which one would you like?",
        "it": "Ho {titles}. Quale preferisci?",
        "ja": "{titles}があります。どれがいいですか？",
    },
    "no_title": {
        "en": "I am sorry, I do not have {title}. But I do have {titles}.",
        "it": "Mi dispiace, non ho {title}. Però ho {titles}.",
        "ja": "ごめんなさい、{title}はないんです。でも、{titles}ならありますよ。",
    },
    "unknown_place": {
        "en": "I am sorry, I do not know yet where that is. Take me there and tell me its name.",
        "it": "Mi dispiace, non so ancora dov'è. Portami lì e dimmi come si chiama.",
        "ja": "ごめんなさい、その場所はまだ知らないんです。一度連れて行って、教えてください。",
    },
    "no_map": {
        "en": "I am sorry, I do not know where I am, because I have no map yet.",
        "it": "Mi dispiace, non so dove mi trovo: non ho ancora una mappa.",
        "ja": "ごめんなさい、まだ地図がないので、自分がどこにいるのか分からないんです。",
    },
    "not_arrived": {
        "en": "I am sorry, I cannot get there. Something is in my way.",
        "it": "Mi dispiace, non riesco ad arrivarci. C'è qualcosa che mi blocca.",
        "ja": "ごめんなさい、何かにふさがれていて、そこまで行けませんでした。",
    },
    "no_dock": {
        "en": "I cannot find my charging place. Would you please take me there?",
        "it": "Non trovo la mia base di ricarica. Mi ci accompagni, per favore?",
        "ja": "充電台が見つかりません。そこまで連れて行っていただけますか？",
    },
    "blocked": {
        "en": "I cannot move any further.",
        "it": "Non posso andare oltre.",
        "ja": "これ以上は進めません。",
    },
    "alert_failed": {
        "en": "I could not reach anybody. Please call for help, or press your call button.",
        "it": "Non sono riuscito a raggiungere nessuno. Chiama aiuto o premi il campanello.",
        "ja": "誰にも連絡がつきませんでした。人を呼ぶか、呼び出しボタンを押してください。",
    },
    "nothing_found": {
        "en": "I am sorry, I found nothing about that.",
        "it": "Mi dispiace, non ho trovato niente.",
        "ja": "すみません、何も見つかりませんでした。",
    },
    "timer_over": {
        "en": "Your time is up!",
        "it": "Il tempo è scaduto!",
        "ja": "時間になりました。",
    },
    "alarm_rings": {
        "en": "It is time! This is the alarm you asked me for.",
        "it": "È ora! È la sveglia che mi hai chiesto.",
        "ja": "お時間ですよ。頼まれていたアラームです。",
    },
    "reminder": {
        "en": "You asked me to remind you: {what}.",
        "it": "Mi hai chiesto di ricordarti: {what}.",
        "ja": "お知らせします。{what}の時間です。",
    },
    "reminder_plain": {
        "en": "You asked me to remind you of something now.",
        "it": "Mi hai chiesto di ricordarti una cosa adesso.",
        "ja": "お知らせを頼まれていた時間になりました。",
    },
}

#: The directions of `move` and `go` in what people answer.
DIRECTIONS = {
    "forward": "forward ahead straight avanti dritto 前 まえ 前進",
    "back": "back backward backwards behind indietro dietro 後 うしろ バック",
    "left": "left sinistra 左 ひだり",
    "right": "right destra 右 みぎ",
}
LEVELS = {
    "on": "on accendi accendere accesa つけ 点け",
    "off": "off spegni spegnere spenta 消",
    "higher": "brighter higher lighter luminoso chiaro 明る",
    "lower": "darker lower dimmer scuro 暗",
}

#: What belongs to saying one's name and is no name.
NAMES = {
    "en": r"(?i)^(?:my name is|my name's|i am called|call me|i am|i'm|it's|it is|this is)\s+",
    "it": r"(?i)^(?:mi chiamo|il mio nome è|sono|io sono|chiamami)\s+",
    "ja": r"^(?:私の名前は|名前は|私は|僕は)|(?:と申します|と言います|といいます|です)$",
}
PLACES = {
    "en": r"(?i)^(?:(?:this is|it is|it's|here is|we are in|in)\s+)?(?:(?:the|my|our|a)\s+)?",
    "it": r"(?i)^(?:(?:questa è|questo è|qui è|è|siamo in|in)\s+)?(?:(?:il|lo|la|mia|mio)\s+|l')?",
    "ja": r"^(?:ここは|これは)|(?:です|だよ)$",
}

#: For `ears: words` without a vocabulary in the settings.
VOCABULARY = {
    "en": ["yes", "no", "hello", "goodbye", "let us talk about music", "let us talk about food"]
    + ["tell me a joke", "play a song", "what time is it", "give me a hug", "help me"],
    "it": ["sì", "no", "ciao", "arrivederci", "parliamo di musica", "parliamo di cucina"]
    + ["raccontami una barzelletta", "suona una canzone", "che ore sono", "dammi un abbraccio"]
    + ["aiutami"],
    "ja": ["はい", "いいえ", "こんにちは", "さようなら", "音楽の話をしましょう"]
    + ["食べ物の話をしましょう", "冗談を言って", "歌をかけて", "今何時ですか", "ハグして"]
    + ["助けて"],
}


def text(name, language, **filled):
    """Return one of the TEXTS."""
    return TEXTS[name][language].format(**filled)


def listed(names, language):
    """Return names as one says them: "A, B and C"."""
    joint = {"en": (", ", " and "), "it": (", ", " e "), "ja": ("、", "、")}[language]
    names = list(names)
    if len(names) < 2:
        return "".join(names)
    return joint[0].join(names[:-1]) + joint[1] + names[-1]


def meant(answer, table):
    """Return the key of a table whose word is in the answer, None where none is."""
    said = (answer or "").lower()
    words = set(re.findall(r"\w+", said, re.UNICODE))
    for key, known in table.items():
        for one in known.split():
            if one in words or (ord(one[0]) > 0x3000 and one in said):
                return key
    return None


def without_frame(answer, frames, language):
    """Return what is left of "My name is Anna.": "Anna"."""
    inner = (answer or "").strip().rstrip(".!。！?？").strip()
    return re.sub(frames[language], "", inner, flags=re.UNICODE).strip() or inner
