"""An invented household, invented words for free text, and fillers.

Home Assistant's package has neither: names of devices, rooms and floors are its users' own.
"""

NAMES = {
    "en": (
        "ceiling lamp",
        "reading lamp",
        "coffee machine",
        "front door",
        "garage door",
        "kitchen radio",
        "big television",
        "night light",
        "air purifier",
        "bathroom fan",
        "left curtain",
        "garden gate",
        "dish washer",
        "old heater",
        "robot cleaner",
        "movie evening",
        "christmas tree",
        "back window",
        "water valve",
        "lawn mower",
    ),
    "it": (
        "lampadario",
        "lampada da lettura",
        "macchinetta del caffè",
        "porta d'ingresso",
        "box auto",
        "radio piccola",
        "televisore grande",
        "lucina notturna",
        "purificatore",
        "ventilatore del bagno",
        "tenda sinistra",
        "cancelletto",
        "lavastoviglie",
        "stufa vecchia",
        "robottino",
        "serata cinema",
        "albero di natale",
        "finestra grande",
        "valvola dell'acqua",
        "tagliasiepi",
    ),
    "ja": (
        "天井灯",
        "読書灯",
        "コーヒーメーカー",
        "玄関の鍵",
        "大きいテレビ",
        "台所のラジオ",
        "常夜灯",
        "空気清浄機",
        "換気扇",
        "扇風機",
        "左のカーテン",
        "食洗機",
        "加湿器",
        "クリスマスツリー",
        "掃除ロボット",
    ),
}
AREAS = {
    "en": ("kitchen", "living room", "bedroom", "bathroom", "hallway", "guest room", "cellar"),
    "it": ("cucina", "soggiorno", "camera da letto", "bagno", "corridoio", "cantina", "veranda"),
    "ja": ("台所", "居間", "寝室", "浴室", "廊下", "客間", "地下室"),
}
FLOORS = {
    "en": ("ground floor", "first floor", "attic"),
    "it": ("piano terra", "primo piano", "mansarda"),
    "ja": ("一階", "二階", "屋根裏"),
}
FREE_TEXT = {
    "en": ("dinner is ready", "blue eggs", "grandma", "paris", "warm socks", "pasta", "my sister"),
    "it": ("cena pronta", "uova blu", "nonna", "parigi", "calzini caldi", "pasta", "mia sorella"),
    "ja": ("夕食", "青い卵", "祖母", "パリ", "靴下"),
}
#: What people put in front of a request or after it; those a library lists are passed over, and a
#: library lists more with every year.
UNLISTED = {
    "en": (("um", "oh well", "hmm", "right then", "honey"), ("honey", "quickly", "will you")),
    "it": (("ehm", "beh senti", "mah", "dunque", "tesoro"), ("tesoro", "dai", "va bene")),
    "ja": (
        (
            "えっと",
            "あのね",
            "ほら",
            "そういえば",
            "いやあ",
            "おっと",
            "なるほど",
            "とにかく",
            "よし",
        ),
        ("なんだけど", "ねえ", "先生", "頼むよ", "ってば"),
    ),
}
