"""What people answer to open questions: none of it asks the agent for anything."""

CHAT = {
    "en": """
I used to play cards with my sister
My mother made it every Sunday
We lived near the sea for twenty years
Yes
No
Maybe
Yes, I love it
No, not really
A little
It depends
I don't know
I'm fine, thank you
I love you
I like it
Not very much
Of course
My grandson is coming tomorrow
I was a teacher for thirty years
We had a small garden with roses
In the summer we went to the lake
My husband died two years ago
I cook it with tomatoes and basil
It reminds me of my childhood
I have three children and five grandchildren
The food here is good
I watched it with my daughter last week
Sometimes I feel lonely
I sleep badly
I never learned to swim
When I was young I danced every Saturday
We played music in the kitchen
It was a long time ago
My favourite was the one with the dog
I think it was in 1960
She loved the theatre
He used to sing to me
Tea in the morning and coffee in the afternoon
With my friends from work
At the market
My father
In Rome
Pizza
The weather was terrible that day
I go to church on Sunday
I read the newspaper every day
That is funny
You are very kind
Thank you very much
I remember the smell of the bread
We went to see a film on our first date
My knee hurts a bit today
I have a pain in my knee
My daughter says hello
I fell asleep in the chair
I have to take my pills now
I can't remember
I can't hear the television
Stop the bus was his favourite joke
I would love to see the sea again
I would like a cup of tea
I'd like to go home
I want to go home
I want my daughter
Show me your hands was what she said
Tell me about it, it was the same for us
We talked about politics at dinner
I hate when it rains on Sunday
What a nice day
""".strip().split("\n"),
    "it": """
Giocavo a carte con mia sorella
Mia madre la faceva ogni domenica
Abbiamo abitato vicino al mare per vent'anni
Sì
No
Forse
Sì, mi piace molto
No, non tanto
Un po'
Dipende
Non lo so
Sto bene, grazie
Ti amo
Mi piace
Mi piace tanto
Non molto
Certo
Domani viene mio nipote
Ho fatto la maestra per trent'anni
Avevamo un piccolo giardino con le rose
D'estate andavamo al lago
Mio marito è morto due anni fa
La cucino con pomodoro e basilico
Mi ricorda l'infanzia
Ho tre figli e cinque nipoti
Qui si mangia bene
L'ho visto con mia figlia la settimana scorsa
A volte mi sento solo
Dormo male
Non ho mai imparato a nuotare
Da giovane ballavo ogni sabato
Suonavamo in cucina
È passato tanto tempo
Il mio preferito era quello col cane
Credo che fosse il 1960
Le piaceva il teatro
Mi cantava le canzoni
Tè la mattina e caffè il pomeriggio
Con i colleghi di lavoro
Al mercato
Mio padre
A Roma
La pizza
Quel giorno il tempo era brutto
La domenica vado in chiesa
Leggo il giornale ogni giorno
Che buffo
Sei molto gentile
Grazie mille
Ricordo il profumo del pane
Al primo appuntamento siamo andati al cinema
Oggi mi fa male un po' il ginocchio
Mi sono addormentato sulla poltrona
Devo prendere le pastiglie
Non mi ricordo
Non sento la televisione
Vorrei un tè
Voglio andare a casa
Vorrei tornare a casa
Mettevo sempre il sale
Metto il basilico alla fine
Cerco di camminare ogni giorno
Che bella giornata
Mi piaceva ballare con lui
A tavola parlavamo di politica
Era una bella canzone
Ho cambiato idea
Con mia moglie
Mi manca mia moglie
Basta un po' di sale
""".strip().split("\n"),
    "ja": """
姉とよくトランプをしました
母が毎週日曜日に作ってくれました
海の近くに二十年住んでいました
はい
いいえ
そうですね
はい、大好きです
いいえ、あまり
少し
場合によります
わかりません
元気です
好きです
大好きです
あまり好きじゃないです
もちろん
明日孫が来ます
三十年間教師をしていました
小さな庭にバラがありました
夏は湖に行きました
夫は二年前に亡くなりました
トマトとバジルで作ります
子どものころを思い出します
子どもが三人と孫が五人います
ここの食事はおいしいです
先週娘と見ました
ときどき寂しくなります
よく眠れません
泳ぎは習いませんでした
若いころは毎週土曜日に踊りました
台所で歌を歌っていました
ずいぶん昔のことです
一九六〇年だったと思います
彼女は芝居が好きでした
朝はお茶、昼はコーヒーです
職場の友だちと
市場で
父です
ローマで
ピザ
あの日は天気が悪かったです
日曜日は教会に行きます
毎日新聞を読みます
面白いですね
ご親切にどうも
ありがとうございます
パンの匂いを覚えています
初めてのデートで映画を見ました
今日は膝が少し痛いです
椅子で寝てしまいました
薬を飲まないといけません
思い出せません
テレビが聞こえません
お茶が飲みたいです
家に帰りたいです
娘に会いたいです
いい天気ですね
食卓で政治の話をしました
いい歌でした
妻と一緒に
妻が恋しいです
母の料理が一番でした
父は釣りが好きでした
犬を飼っていました
京都に行ったことがあります
よく音楽を聴いていました
昔は手紙を書きました
友だちと話すのが楽しかったです
電車の音を覚えています
春になると桜を見に行きました
""".strip().split("\n"),
}
