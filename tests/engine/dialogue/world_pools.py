"""The pools of the small world: two or three sentences each, in three languages."""

_TABLE = {
    "abilities": (
        "I can $list.|Among other things, I can $list.",
        "So $list.|Per esempio so $list.",
        "$listことができます。|たとえば$listことです。",
    ),
    "joke": (
        "A joke.|Another joke.",
        "Ecco: barzelletta.|Ancora: barzelletta.",
        "冗談です。|もう一つの冗談です。",
    ),
    "riddle": (
        "A riddle.|Another riddle.",
        "Ecco: indovinello.|Ancora: indovinello.",
        "なぞなぞです。|もう一つのなぞなぞです。",
    ),
    "proverb": (
        "A proverb.|Another proverb.",
        "Ecco: proverbio.|Ancora: proverbio.",
        "ことわざです。|もう一つのことわざです。",
    ),
    "curiosity": (
        "A curiosity.|Another curiosity.",
        "Ecco: curiosità.|Ancora: curiosità.",
        "豆知識です。|もう一つの豆知識です。",
    ),
    "story": (
        "A story.|Another story.",
        "Ecco: storia.|Ancora: storia.",
        "お話です。|もう一つのお話です。",
    ),
    "poem": (
        "A poem.|Another poem.",
        "Ecco: poesia.|Ancora: poesia.",
        "詩です。|もう一つの詩です。",
    ),
    "prayer": (
        "A prayer.|Another prayer.",
        "Ecco: preghiera.|Ancora: preghiera.",
        "お祈りです。|もう一つのお祈りです。",
    ),
    "breathing": (
        "A breath.|Another breath.",
        "Ecco: respiro.|Ancora: respiro.",
        "呼吸です。|もう一つの呼吸です。",
    ),
    "start": (
        "Hello, $name!|Good to see you.",
        "Ciao, $name!|Che bello vederti.",
        "こんにちは。|お会いできてうれしいです。",
    ),
    "welcome_back": (
        "Welcome back.|Here you are again.",
        "Bentornato.|Rieccoci.",
        "お帰りなさい。|またお会いしましたね。",
    ),
    "acknowledge": (
        "I see.|Thank you for telling me.|I am listening.",
        "Capisco.|Grazie di avermelo detto.|Ti ascolto.",
        "そうですか。|お話しくださってありがとうございます。|はい、聞いております。",
    ),
    "neutral": (
        "That depends, of course.|Fair enough.",
        "Dipende, certo.|Giusto.",
        "場合によりますね。|なるほど。",
    ),
    "opener": (
        "Ah, $toName!|You said $toName.",
        "Ah, $toName!|Hai detto $toName.",
        "$toNameですね。|ああ、$toName。",
    ),
    "disliked": (
        "Once more $toName.|$toName again.",
        "Ancora $toName.|Di nuovo $toName.",
        "また$toNameです。|$toNameに戻ります。",
    ),
    "begin": (
        "Shall we begin with $toName?|First, $toName.",
        "Cominciamo: $toName.|Per prima cosa, $toName.",
        "まず$toNameです。|$toNameから始めます。",
    ),
    "gentle": (
        "I hear you.|Take your time.",
        "Ti sento.|Fai con calma.",
        "お聞きしています。|ごゆっくりどうぞ。",
    ),
    "stay_or_go": (
        "Stay with it, or go on?|What would do you good?",
        "Restiamo qui o andiamo avanti?|Che cosa ti farebbe bene?",
        "このままにしましょうか？|どうしましょうか？",
    ),
    "transition": (
        "From $hasName to $toName.|After $hasName, $toName.",
        "$hasName.da $toName.a.|Dopo $hasName, $toName.",
        "$hasNameから$toNameへ。|$hasNameの次は$toNameです。",
    ),
    "change": (
        "Let us turn to $toName.|Now to $toName.",
        "Passiamo $toName.a.|E ora $toName.",
        "$toNameのお話です。|次は$toNameです。",
    ),
    "leave": (
        "No more $hasName, then.|We leave $hasName alone.",
        "Allora basta $hasName.|Lasciamo $hasName.",
        "$hasNameはやめましょう。|$hasNameは置いておきます。",
    ),
    "change_asked": (
        "Something else, then.|Gladly, another subject.",
        "Altro, allora.|Cambiamo.",
        "別のお話に。|話題を変えます。",
    ),
    "not_understood": (
        "That I do not know.|I have no answer.",
        "Questo non lo so.|Non so rispondere.",
        "それはわかりません。|お答えできません。",
    ),
    "wish": (
        "Tell me about $what.|What about $what?",
        "Raccontami: $what.|E $what?",
        "$whatのお話を。|$whatですか？",
    ),
    "fond": (
        "You are fond of $what.|So dear: $what.",
        "Ti sta a cuore: $what.|Cara cosa: $what.",
        "$whatがお好きですね。|大切な$what。",
    ),
    "averse": (
        "Not $what, I hear.|So $what is not for you.",
        "Niente $what.|Non fa per te: $what.",
        "$whatは苦手ですね。|$whatはやめます。",
    ),
    "opinion": (
        "If you ask me.|In my view.",
        "Secondo me.|A mio parere.",
        "私はこう思います。|私の考えですが。",
    ),
    "repeat": ("I said this.|Once more.", "Ho detto così.|Ripeto.", "もう一度。|繰り返します。"),
    "nothing_to_repeat": (
        "I said nothing yet.|There is nothing to say again.",
        "Non ho detto nulla.|Niente da ripetere.",
        "まだ何も。|繰り返すことがありません。",
    ),
    "goal_accepted": (
        "Here we go.|With pleasure.",
        "Si comincia.|Con piacere.",
        "始めます。|喜んで。",
    ),
    "goal_refused": (
        "Another time.|As you like.",
        "Un'altra volta.|Come vuoi.",
        "またの機会に。|わかりました。",
    ),
    "forget": (
        "It is forgotten.|Gone from my memory.",
        "Dimenticato.|Non ricordo più.",
        "忘れました。|消しました。",
    ),
    "list": (
        "We could talk about $list.|There is $list.",
        "Possiamo parlare di: $list.|C'è: $list.",
        "$listなどいかがですか。|$listがあります。",
    ),
    "initiative": (
        "What is on your mind?|What shall we talk about?",
        "A che cosa pensi?|Di che cosa parliamo?",
        "何をお話ししましょう？|何が気になりますか？",
    ),
    "end": (
        "Goodbye.|Until next time.",
        "Arrivederci.|Alla prossima.",
        "さようなら。|またお会いしましょう。",
    ),
    "after_end": (
        "Still here.|You are back.",
        "Sono qui.|Eccoti.",
        "おります。|お帰りなさいませ。",
    ),
    "urgent": (
        "Stay calm.|Help is near.",
        "Calma.|L'aiuto è vicino.",
        "落ち着いて。|助けが来ます。",
    ),
    "apology": (
        "I did not hear you.|Pardon me.",
        "Non ho sentito.|Scusami.",
        "聞こえませんでした。|失礼しました。",
    ),
}

LANGUAGE_CODES = ("en", "it", "ja")


def rows() -> list[tuple[str, int, dict[str, str]]]:
    """Return pool, place and texts of each sentence."""
    found = []
    for pool, columns in _TABLE.items():
        sentences = zip(*(column.split("|") for column in columns), strict=True)
        for place, texts in enumerate(sentences, 1):
            found.append((pool, place, dict(zip(LANGUAGE_CODES, texts, strict=True))))
    return found
