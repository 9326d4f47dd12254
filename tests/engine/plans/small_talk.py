"""More of what people answer to open questions: several clauses, stories; none of it a request."""

_LINES = {
    "en": """
Now and then
We always had fish on Friday because my father was a fisherman
My mother used to bake bread twice a week and the whole street could smell it
I never liked spinach when I was a child but now I eat it
A plate of soup in the evening is enough for me
We grew our own potatoes and beans behind the house
My grandmother kept the recipe in her head and took it with her
On Sunday we had roast chicken and everybody came
The coffee in the hospital tasted of nothing
I can still cook for ten people if I have to
Sugar was hard to find during the war
My wife does the cooking and I do the washing up
I put a little nutmeg in it, that is the secret
We ate what there was and nobody complained
An apple a day, that is what the doctor told me
I burnt the cake on the day of my wedding
Chocolate, I could eat it every day
The first time I tried curry was in London
He would not eat anything green
Breakfast is the meal I enjoy least
We made jam in August, pots and pots of it
My brother was the eldest of seven
My son lives in Australia so I don't see him often
My daughter calls me every evening at six
I met my husband at a dance in the village hall
We were married for fifty two years
My sister and I shared a bed until she got married
The grandchildren are growing up so fast
My father worked in the mine and came home black as coal
She looks just like her mother did at that age
I named him after my uncle who died at sea
We lost a baby and did not speak about it
They come at Christmas and stay for three days
My youngest plays the violin in an orchestra
My parents did not have much but we were happy
He was a quiet man who liked his garden
I was an only child, so I talked to the dog
Our house was always full of people
My niece is expecting her first child in spring
My mother in law was a difficult woman
He asked me to marry him on the bus
We sang in the church choir, my sister and I
I used to listen to the radio under the blanket
My husband played the accordion at weddings
The Beatles came to our town once
That song was playing when we met
I can't sing but I do it anyway
My father had an old gramophone with a big horn
We danced until the shoes fell apart
I learned the piano from the nuns and they were strict
Opera makes me cry every time
I still have all the records in the attic
The music today is too loud for my ears
My grandson plays the drums and the neighbours complain
There was a band in the park every Saturday
I know that one by heart
We went to Spain on a coach and it took two days
I have never been on a plane in my life
My dream was to see New York but it never happened
We spent our honeymoon in Venice and it rained all week
The sea was cold but we went in every day
I lost my suitcase in Paris and had to buy everything new
He drove and I read the map and we always quarrelled
We slept in a tent next to a river
I would have liked to see the pyramids
The mountains were covered with snow in May
My brother emigrated to Canada in fifty six
We took the train to my aunt in the country
I got so sunburnt that I could not sit down
It was the furthest I had ever been from home
A cousin of mine still lives in Naples
I saw the Queen once from far away
The ferry was late and we missed the last bus
I started work when I was fourteen
I worked in a shoe factory for twenty years
They gave me a clock when I retired
I was a nurse on the night shift
My first boss was a terrible man but he taught me everything
We had to be there at five to milk the cows
I typed letters all day for a lawyer
The pay was bad but we had a good laugh
I delivered the post on a bicycle
My father wanted me to be a teacher like him
I was the only woman in the office
When the factory closed we all cried
I drove a lorry all over the country
I sewed dresses for the ladies in town
The children called me Miss even at the market
I went to evening school to become a bookkeeper
My back hurts when the weather changes
I had my hip done last year and now I walk better
The doctor says my heart is strong
My eyes are not what they used to be
I take a tablet in the morning and one at night
I was in hospital for three weeks in the winter
The stairs are getting harder every year
I sleep four hours and then I lie awake
My hands shake so I don't write any more
I gave up smoking when my son was born
I have good days and bad days
The nurse comes twice a week to change the bandage
I try to walk to the shop and back
My hearing aid whistles all the time
I had measles, mumps, everything you can think of
It is no fun to get old but what can you do
I feel a bit tired after lunch
I wear glasses only for reading
We had a dog called Max who followed me to school
My cat sleeps on my bed although she is not allowed
I kept bees for a while after I retired
The hens knew me and came when I called
We once found a hedgehog in the kitchen
My husband was afraid of horses
The budgie could say its own name
I have planted tomatoes on the balcony
Roses need a lot of care but they are worth it
The garden is too much for me now
In autumn we collected chestnuts in the woods
There was so much snow that we climbed out of the window
I remember the smell of hay
I was seven when the war ended
We had no television until I was twenty
The whole street came to us to watch the moon landing
At school we wrote on slates
The teacher hit us with a ruler
I was good at sums but not at spelling
My best friend moved away and I cried for a week
We walked an hour to school in all weathers
I left school to look after my brothers
We played marbles in the street until it was dark
My doll had a china head and I broke it
I had one pair of shoes for the whole year
Christmas was an orange and a handful of nuts
My first kiss was behind the barn
I had a red bicycle that was stolen
I knit socks for everybody in the family
On Tuesday I play cards with the ladies upstairs
I read the paper from back to front
I do the crossword with my coffee
Chess was my husband's great passion
I watch the quiz in the evening and then I go to bed
I used to go to every match with my brother
We won the cup in sixty eight and nobody slept
I never understood the rules of rugby
I swam across the lake when I was eighteen
I used to run but my knees said no
I paint a little, mostly flowers
The library van comes on Thursday
I have read that book three times
I prefer stories with a happy ending
My favourite actor was Cary Grant
We saw the film four times because of him
I fell asleep before the end
The news is always the same so I switch it off
I don't understand these telephones
My granddaughter showed me how to send a picture
I write letters by hand, nobody does that any more
My neighbour brings me the milk
I talk to the lady next door over the fence
I miss having somebody to talk to in the evening
I am never bored, there is always something to do
I was shy as a girl
People used to have more time for each other
I would do it all again
I have no regrets, well, perhaps one
It was not easy but we managed
I laughed so much that I had to sit down
I was so proud of her that day
I get angry when people are rude
I am afraid of the dark, silly isn't it
I feel at home here now
Nothing special, just a normal day
I got up early and watered the plants
My son is picking me up at four
Today is my granddaughter's birthday
I went to the hairdresser this morning
We had a lovely lunch with the neighbours
It was raining so I stayed in
I am waiting for the doctor
I have an appointment at the dentist on Monday
They say it will snow on Sunday
I hope the weather holds for the wedding
I like spring because everything starts again
Summer is too hot for me these days
I go to bed when the birds do
I light a candle for my husband on Sunday
I pray every night before I sleep
The priest was a friend of the family
I don't believe in much but I believe in kindness
I vote every time, my father fought for that
Money never meant much to us
We saved for ten years to buy the house
It was a small flat with a view of the harbour
I was born upstairs in that house
The kitchen was the warmest room
I still have my mother's sewing machine
I threw away too many letters
I keep his photograph next to the bed
He whistled when he came home so that I knew
She could make anything out of nothing
He told the same joke for forty years
They were good times although we had nothing
You should have seen him in his uniform
You would have laughed
You know how children are
You remind me of my grandson
You have a nice voice
What can I say, that is life
What a day that was
Who would have thought it
How time flies
Well, that depends on the day
Oh, that is a long story
Let me think, it must have been in spring
That is a difficult question
I have never thought about it
I could not tell you
I am not sure any more
I forgot what I wanted to say
It slipped my mind
Nobody ever asked me that before
Not that I remember
I suppose so
Not any more
More or less
Every now and again
Only on Sunday
Both of them
With milk and no sugar
The red one
In the kitchen
Next to the church
A long time ago
Twice a week
Almost every day
At the seaside with my parents
The three of us
My mother, of course
My friend Rosa
A teacher and a farmer
Because it was cheaper
Since I was a little girl
Yes, when I was young
Yes, with my sister
Yes, we had two
No, never
No, I was too young
No, my husband did that
No, but I would have loved to
Yes, but only a little
We played in the snow all day and came home with wet feet
She plays the organ at church and people love it
I play bingo on Wednesday and sometimes I win
We stopped at every village on the way
I stopped dancing after the operation
He told me a story every night about a fox
They showed us how to make cheese
I told him about the accident
We talked all night about the old days
She always says hello to me in the lift
I called my sister but she was not at home
The music stopped and nobody moved
He turned off the radio and went to bed
I set the table and waited for him
We changed trains in Milan
I forget names but never faces
I looked for my glasses all morning
I opened the window and there was a bird
My brother read the news on the radio
I remember the weather on that day
I heard the film was good but sad
I went to the doctor about my knee
He helped me when I was in trouble
I gave my brother a call on his birthday
Nobody came to help us with the harvest
I was lost in the city and a policeman brought me home
""",
    "it": """
Eh, è una storia lunga
Il venerdì mangiavamo sempre pesce perché mio padre faceva il pescatore
Mia madre faceva il pane due volte alla settimana e si sentiva il profumo in tutta la via
Da bambina gli spinaci non li mangiavo ma adesso sì
La sera mi basta un piatto di minestra
Le patate e i fagioli li coltivavamo dietro casa
La nonna teneva la ricetta in testa e se l'è portata via
La domenica c'era il pollo arrosto e venivano tutti
Il caffè dell'ospedale non sapeva di niente
Se serve cucino ancora per dieci persone
In tempo di guerra lo zucchero non si trovava
Mia moglie cucina e io lavo i piatti
Ci metto un po' di noce moscata, è quello il segreto
Si mangiava quello che c'era e nessuno si lamentava
Una mela al giorno, così mi diceva il medico
Il giorno del matrimonio ho bruciato la torta
La cioccolata la mangerei tutti i giorni
La prima volta che ho assaggiato il curry ero a Londra
Di verde non mangiava niente
La colazione è il pasto che sento di meno
Ad agosto facevamo la marmellata, vasi e vasi
Mio fratello era il più grande di sette
Mio figlio vive in Australia e lo vedo poco
Mia figlia mi chiama tutte le sere alle sei
Ho conosciuto mio marito a ballare
Siamo stati sposati cinquantadue anni
Io e mia sorella dormivamo nello stesso letto
I nipoti crescono così in fretta
Mio padre lavorava in miniera e tornava nero come il carbone
È tutta sua madre alla stessa età
Gli ho dato il nome di mio zio che è morto in mare
Abbiamo perso un bambino e non ne parlavamo mai
Vengono a Natale e restano tre giorni
Il più piccolo suona il violino in un'orchestra
I miei genitori non avevano molto ma eravamo felici
Era un uomo tranquillo che amava il suo orto
Ero figlia unica e parlavo con il cane
La nostra casa era sempre piena di gente
Mia nipote aspetta il primo figlio in primavera
Mia suocera era una donna difficile
Mi ha chiesto di sposarlo sull'autobus
Cantavamo nel coro della chiesa, io e mia sorella
Ascoltavo la radio sotto le coperte
Mio marito suonava la fisarmonica ai matrimoni
Una volta è venuta Mina nel nostro paese
Quando ci siamo conosciuti c'era quella canzone
Non so cantare ma canto lo stesso
Mio padre aveva un vecchio grammofono con la tromba
Abbiamo ballato fino a consumare le scarpe
Il pianoforte l'ho imparato dalle suore, che erano severe
L'opera mi fa piangere ogni volta
Ho ancora tutti i dischi in soffitta
La musica di oggi è troppo forte per le mie orecchie
Mio nipote suona la batteria e i vicini si lamentano
Il sabato c'era la banda in piazza
Quella la so a memoria
Siamo andati in Spagna in pullman e ci abbiamo messo due giorni
Non ho mai preso un aereo in vita mia
Il mio sogno era vedere New York ma non è mai successo
In viaggio di nozze siamo stati a Venezia e ha piovuto sempre
Il mare era freddo ma facevamo il bagno tutti i giorni
A Parigi ho perso la valigia e ho dovuto ricomprare tutto
Lui guidava, io leggevo la cartina e si litigava
Abbiamo dormito in tenda vicino a un fiume
Avrei voluto vedere le piramidi
A maggio le montagne erano ancora piene di neve
Mio fratello è emigrato in Canada nel cinquantasei
Prendevamo il treno per andare da mia zia in campagna
Mi sono scottata così tanto che non potevo sedermi
Non ero mai stata così lontano da casa
Un mio cugino abita ancora a Napoli
Una volta ho visto il Papa da lontano
Il traghetto era in ritardo e abbiamo perso l'ultimo autobus
Ho cominciato a lavorare a quattordici anni
Ho lavorato vent'anni in un calzaturificio
Quando sono andato in pensione mi hanno dato un orologio
Facevo l'infermiera di notte
Il mio primo padrone era terribile ma mi ha insegnato tutto
Alle cinque bisognava essere nella stalla a mungere
Battevo a macchina tutto il giorno per un avvocato
La paga era poca ma si rideva
Consegnavo la posta in bicicletta
Mio padre voleva che facessi la maestra come lui
Ero l'unica donna dell'ufficio
Quando hanno chiuso la fabbrica abbiamo pianto tutti
Ho guidato il camion per tutta l'Italia
Cucivo i vestiti per le signore del centro
I bambini mi chiamavano maestra anche al mercato
Sono andato alla scuola serale per diventare ragioniere
Quando cambia il tempo mi fa male la schiena
L'anno scorso mi hanno operato all'anca e ora cammino meglio
Il medico dice che il cuore è forte
Gli occhi non sono più quelli di una volta
Prendo una pastiglia la mattina e una la sera
D'inverno sono stata tre settimane in ospedale
Le scale diventano più dure ogni anno
Dormo quattro ore e poi resto sveglia
Mi tremano le mani e quindi non scrivo più
Ho smesso di fumare quando è nato mio figlio
Ho giorni buoni e giorni cattivi
L'infermiera viene due volte alla settimana per la medicazione
Cerco di andare a piedi fino al negozio e ritorno
L'apparecchio acustico fischia in continuazione
Ho avuto il morbillo, gli orecchioni, di tutto
Invecchiare non è bello ma che ci vuoi fare
Dopo pranzo sono un po' stanca
Gli occhiali li porto solo per leggere
Avevamo un cane, Max, che mi seguiva a scuola
La gatta dorme sul mio letto anche se non dovrebbe
In pensione ho tenuto le api per qualche anno
Le galline mi conoscevano e venivano quando chiamavo
Una volta abbiamo trovato un riccio in cucina
Mio marito aveva paura dei cavalli
Il pappagallino sapeva dire il suo nome
Ho piantato i pomodori sul balcone
Le rose vogliono tante cure ma ne vale la pena
Il giardino ormai è troppo per me
In autunno raccoglievamo le castagne nel bosco
C'era tanta neve che uscivamo dalla finestra
Mi ricordo l'odore del fieno
Avevo sette anni quando è finita la guerra
Non avevamo la televisione fino ai miei vent'anni
Tutta la via venne da noi a vedere lo sbarco sulla Luna
A scuola si scriveva con il pennino
Il maestro ci picchiava con la bacchetta
Ero brava nei conti ma non in ortografia
La mia migliore amica si è trasferita e ho pianto una settimana
Si andava a scuola a piedi, un'ora con qualsiasi tempo
Ho lasciato la scuola per badare ai fratelli
Si giocava a biglie per strada finché faceva buio
La mia bambola aveva la testa di porcellana e l'ho rotta
Avevo un paio di scarpe per tutto l'anno
A Natale un'arancia e una manciata di noci
Il primo bacio l'ho dato dietro il fienile
Avevo una bicicletta rossa e me l'hanno rubata
Faccio le calze a tutta la famiglia
Il martedì gioco a carte con le signore di sopra
Il giornale lo leggo dal fondo
Con il caffè faccio le parole crociate
Gli scacchi erano la grande passione di mio marito
La sera guardo il quiz e poi vado a letto
Andavo a tutte le partite con mio fratello
Quando vincemmo la coppa non dormì nessuno
Le regole del rugby non le ho mai capite
A diciotto anni ho attraversato il lago a nuoto
Correvo ma le ginocchia hanno detto basta
Dipingo un poco, soprattutto fiori
Il giovedì passa il furgone della biblioteca
Quel libro l'ho letto tre volte
Preferisco le storie che finiscono bene
Il mio attore preferito era Mastroianni
Il film l'abbiamo visto quattro volte per causa sua
Mi sono addormentata prima della fine
Il telegiornale dice sempre le stesse cose e lo spengo
Questi telefoni non li capisco
Mia nipote mi ha insegnato a mandare le fotografie
Le lettere le scrivo a mano, ormai non lo fa più nessuno
La vicina mi porta il latte
Parlo con la signora accanto attraverso la siepe
La sera mi manca qualcuno con cui parlare
Non mi annoio mai, c'è sempre qualcosa da fare
Da ragazza ero timida
Una volta la gente aveva più tempo
Rifarei tutto
Non ho rimpianti, cioè, forse uno
Non è stato facile ma ce l'abbiamo fatta
Ho riso tanto che mi sono dovuta sedere
Quel giorno ero così orgogliosa di lei
Mi arrabbio quando la gente è maleducata
Ho paura del buio, che sciocchezza
Ormai qui mi sento a casa
Niente di speciale, una giornata normale
Mi sono alzata presto e ho annaffiato le piante
Mio figlio viene a prendermi alle quattro
Oggi è il compleanno di mia nipote
Stamattina sono stata dalla parrucchiera
Abbiamo fatto un bel pranzo con i vicini
Pioveva e quindi sono rimasta dentro
Sto aspettando il dottore
Lunedì ho l'appuntamento dal dentista
Dicono che domenica nevica
Speriamo che il tempo tenga per il matrimonio
La primavera mi piace perché ricomincia tutto
D'estate ormai fa troppo caldo
Vado a letto con le galline
La domenica accendo una candela per mio marito
Prego tutte le sere prima di dormire
Il parroco era un amico di famiglia
Non credo in molte cose ma nella gentilezza sì
Vado sempre a votare, mio padre ha lottato per questo
I soldi per noi non contavano
Abbiamo risparmiato dieci anni per comprare la casa
Era un appartamentino con la vista sul porto
Sono nata al piano di sopra di quella casa
La cucina era la stanza più calda
Ho ancora la macchina da cucire di mia madre
Ho buttato via troppe lettere
Tengo la sua fotografia vicino al letto
Quando tornava fischiava così lo sentivo
Con niente faceva tutto
Ha raccontato la stessa barzelletta per quarant'anni
Erano bei tempi anche se non avevamo niente
Dovevi vederlo in divisa
Avresti riso anche tu
Sai come sono i bambini
Mi ricordi mio nipote
Hai una bella voce
Che vuoi, è la vita
Che giornata quella
Chi l'avrebbe mai detto
Come passa il tempo
Beh, dipende dai giorni
Mah, è una storia lunga
Fammi pensare, doveva essere primavera
È una domanda difficile
Non ci ho mai pensato
Non saprei dirti
Non ne sono più sicura
Ho dimenticato che cosa volevo dire
Mi è passato di mente
Non me l'aveva mai chiesto nessuno
Che io ricordi no
Credo di sì
Ormai no
Più o meno
Ogni tanto
Solo la domenica
Tutti e due
Con il latte e senza zucchero
Quella rossa
In cucina
Vicino alla chiesa
Tanto tempo fa
Due volte alla settimana
Quasi tutti i giorni
Al mare con i miei genitori
Noi tre
Mia madre, naturalmente
La mia amica Rosa
Un maestro e un contadino
Perché costava meno
Da quando ero piccola
Sì, da giovane
Sì, con mia sorella
Sì, ne avevamo due
No, mai
No, ero troppo giovane
No, lo faceva mio marito
No, ma mi sarebbe piaciuto
Sì, ma solo un poco
Giocavamo nella neve tutto il giorno e tornavamo con i piedi bagnati
Mia cognata suona l'organo in chiesa e la gente le vuole bene
Il mercoledì gioco a tombola e qualche volta vinco
Ci fermavamo in tutti i paesi lungo la strada
Ho smesso di ballare dopo l'operazione
Ogni sera mi raccontava una storia di una volpe
Ci hanno mostrato come si fa il formaggio
Gli ho raccontato dell'incidente
Abbiamo parlato tutta la notte dei vecchi tempi
In ascensore mi dice sempre buongiorno
Ho chiamato mia sorella ma non era in casa
La musica è finita e nessuno si è mosso
Ha spento la radio ed è andato a letto
Ho apparecchiato e l'ho aspettato
Abbiamo cambiato treno a Milano
I nomi li dimentico ma le facce mai
Ho cercato gli occhiali tutta la mattina
Ho aperto la finestra e c'era un uccellino
Mio fratello leggeva le notizie alla radio
Mi ricordo che tempo faceva quel giorno
Ho sentito che il film è bello ma triste
Sono andata dal dottore per il ginocchio
Mi ha aiutato quando ero nei guai
Ho telefonato a mio fratello per il compleanno
Nessuno è venuto ad aiutarci con la vendemmia
Mi ero persa in città e un vigile mi ha portato a casa
""",
    "ja": """
父が漁師だったので金曜はいつも魚でした
母は週に二回パンを焼いて、通りじゅうにいい匂いがしました
子どもの頃はほうれん草が苦手でしたが今は食べます
夜はみそ汁とご飯で十分です
家の裏でじゃがいもと豆を作っていました
祖母は作り方を誰にも教えずに逝ってしまいました
日曜日はみんな集まってすき焼きをしました
病院のご飯は味がしませんでした
今でも十人分くらいは作れますよ
戦争中は砂糖が手に入りませんでした
料理は妻がして、私は皿洗いです
かくし味に味噌を少し入れるんです
あるものを食べて、誰も文句は言いませんでした
りんごを毎日食べなさいと先生に言われました
結婚式の日にケーキを焦がしてしまって
チョコレートなら毎日でも食べられます
初めてカレーを食べたのは東京でした
緑のものは何も食べない子でした
朝ご飯はあまり食べません
八月には梅干しをたくさん漬けました
兄は七人兄弟の一番上でした
息子はオーストラリアにいるのでなかなか会えません
娘が毎晩六時に電話をくれるんです
主人とは盆踊りで知り合いました
五十二年間連れ添いました
妹と同じ布団で寝ていました
孫はあっという間に大きくなりますね
父は炭鉱で働いて真っ黒になって帰ってきました
あの子は若い頃の母親にそっくりです
海で亡くなった叔父の名前をもらいました
お正月に来て三日泊まっていきます
末っ子はオーケストラでバイオリンを弾いています
両親は貧しかったけれど幸せでした
静かな人で、庭いじりばかりしていました
一人っ子だったので犬とばかり話していました
うちはいつも人でいっぱいでした
姪に春に赤ちゃんが生まれます
姑は厳しい人でしたよ
バスの中で結婚を申し込まれたんです
妹と一緒に合唱団で歌っていました
布団の中でこっそりラジオを聞いていました
主人は宴会でよく三味線を弾きました
美空ひばりが一度町に来たことがあります
出会った時にその歌が流れていました
歌は下手ですがそれでも歌います
父は古い蓄音機を持っていました
足が痛くなるまで踊りましたよ
ピアノの先生はとても厳しかったです
歌舞伎を見ると毎回泣いてしまいます
レコードはまだ全部押し入れにあります
今の音楽は私にはうるさすぎます
孫が太鼓をたたくので近所から苦情が来ます
土曜日には公園で楽団が演奏していました
それは全部覚えています
バスで九州まで行って二日かかりました
飛行機には一度も乗ったことがありません
ハワイに行くのが夢でしたがかないませんでした
新婚旅行は熱海で、ずっと雨でした
海は冷たかったけれど毎日泳ぎました
京都で鞄をなくして全部買い直しました
主人が運転して私が地図を見て、いつもけんかでした
川のそばにテントを張って寝ました
ピラミッドを見てみたかったです
五月なのに山は雪で真っ白でした
兄は昭和三十一年にブラジルへ渡りました
汽車に乗って田舎の叔母の家へ行きました
日に焼けて座れないほどでした
あんなに遠くへ行ったのは初めてでした
いとこがまだ長崎に住んでいます
一度だけ遠くから天皇陛下を見ました
船が遅れて最後のバスに間に合いませんでした
十四歳で働き始めました
靴の工場で二十年働きました
定年の時に時計をもらいました
夜勤の看護婦をしていました
最初の上司は怖かったけれど何でも教えてくれました
朝五時には牛の乳をしぼっていました
弁護士の事務所で一日中タイプを打っていました
給料は安かったけれど楽しかったです
自転車で郵便を配っていました
父は私を教師にしたかったんです
職場で女は私だけでした
工場が閉まった時はみんな泣きました
トラックで日本中を走りました
町の奥さんたちの着物を縫っていました
市場でも子どもたちに先生と呼ばれました
夜学に通って簿記を習いました
天気が変わると背中が痛みます
去年腰の手術をして歩きやすくなりました
心臓は丈夫だと先生に言われました
目も昔のようには見えません
朝と夜に一錠ずつ飲んでいます
冬に三週間入院していました
階段が年々きつくなります
四時間眠ると目が覚めてしまいます
手が震えるのでもう字は書きません
息子が生まれた時にたばこをやめました
いい日もあれば悪い日もあります
看護師さんが週に二回来てくれます
店まで歩いて帰ってくるようにしています
補聴器がずっと鳴っているんです
はしかもおたふくも全部やりました
年を取るのは嫌ですが仕方ありません
お昼のあとは少し疲れます
眼鏡は読む時だけかけます
学校までついてくる犬がいました
猫が私の布団で寝るんです
定年後にしばらく蜂を飼っていました
呼ぶと鶏が集まってきました
台所に狸が入ってきたことがあります
主人は馬が怖かったんです
インコが自分の名前を言えました
ベランダにトマトを植えました
バラは手がかかりますがきれいです
庭の手入れはもう無理です
秋には山で栗を拾いました
雪が深くて窓から出入りしました
干し草の匂いを覚えています
終戦の時は七つでした
二十歳までテレビがありませんでした
月面着陸はご近所がみんなうちに見に来ました
学校では石板に書いていました
先生に物差しで叩かれました
算数は得意でしたが作文は苦手でした
親友が引っ越して一週間泣きました
どんな天気でも一時間歩いて通いました
弟たちの世話で学校をやめました
暗くなるまで道でビー玉をしていました
人形の首を折ってしまって叱られました
靴は一年に一足だけでした
お正月にみかんをもらうのがうれしかったです
赤い自転車を盗まれました
家族みんなに靴下を編んでいます
火曜日は上の階の人と花札をします
新聞は後ろから読みます
コーヒーを飲みながらクロスワードをします
将棋は主人の生きがいでした
夜はクイズを見てから寝ます
兄と毎回試合を見に行きました
優勝した時は誰も寝ませんでした
ラグビーの決まりはわかりません
十八の時に湖を泳いで渡りました
前は走っていましたが膝がだめになりました
少し絵を描きます、花が多いですね
木曜日に図書館の車が来ます
その本は三回読みました
最後が幸せな話のほうがいいです
好きな俳優は三船敏郎でした
その人のために四回も見ました
終わる前に寝てしまいました
ニュースはいつも同じなので消します
最近の電話はよくわかりません
孫に写真の送り方を教わりました
手紙は手で書きます
お隣さんが牛乳を持ってきてくれます
垣根越しに隣の奥さんと話します
夜に話し相手がいないのが寂しいです
退屈しません、いつもすることがあります
若い頃は恥ずかしがり屋でした
昔の人はもっと時間がありましたね
もう一度同じ人生でもいいです
後悔はありません、まあ一つくらいは
大変でしたが何とかなりました
笑いすぎて座り込んでしまいました
あの日は本当に誇らしかったです
失礼な人には腹が立ちます
暗いところが怖いんです、おかしいでしょう
もうここが我が家のようです
特に何もない普通の日でした
早起きして植木に水をやりました
四時に息子が迎えに来ます
今日は孫の誕生日なんです
今朝は美容院に行きました
ご近所さんと楽しくお昼を食べました
雨だったので家にいました
お医者さんを待っているところです
月曜日に歯医者の予約があります
日曜は雪になるそうです
結婚式の日は晴れるといいのですが
春は全部が始まるからいいですね
夏はもう暑すぎます
鳥と一緒に寝ます
日曜には仏壇に手を合わせます
寝る前に毎晩お祈りをします
お坊さんは家族の友だちでした
信心はありませんが親切は信じています
選挙には必ず行きます
お金は大事ではありませんでした
家を買うのに十年貯金しました
港の見える小さな部屋でした
その家の二階で生まれました
台所が一番暖かい部屋でした
母のミシンをまだ持っています
手紙を捨てすぎました
枕元に写真を置いています
口笛で帰ってきたのがわかりました
何もないところから何でも作る人でした
四十年間同じ冗談を言っていました
何もなかったけれどいい時代でした
制服姿を見せたかったです
あなたも笑ったでしょうね
子どもはそういうものですよ
孫を思い出します
いい声ですね
人生ってそういうものです
あれはすごい日でした
誰が思ったでしょう
時がたつのは早いですね
まあ、日によります
ああ、それは長い話です
春だったと思います
難しい質問ですね
考えたこともありません
何とも言えません
もうはっきりしません
言おうとしたことを忘れました
うっかりしていました
そんなことを聞かれたのは初めてです
覚えている限りではないです
そうだと思います
もうしません
だいたいそうです
時々ですね
日曜日だけです
両方ともです
牛乳を入れて砂糖なしで
赤いほうです
台所で
お寺の隣です
ずっと昔です
週に二回です
ほとんど毎日です
両親と海で
三人でした
もちろん母です
友だちの花子さん
先生と農家でした
安かったからです
小さい時からです
はい、若い頃に
はい、妹と
はい、二匹いました
いいえ、一度も
いいえ、まだ小さかったので
いいえ、主人がしました
いいえ、でもしたかったです
はい、でも少しだけ
一日中雪で遊んで足を濡らして帰りました
教会でオルガンを弾いて喜ばれています
水曜日にビンゴをして時々当たります
道の途中で村ごとに止まりました
手術のあと踊るのをやめました
毎晩きつねの話をしてくれました
チーズの作り方を見せてもらいました
事故のことを話しました
昔の話を一晩中しました
エレベーターでいつも挨拶してくれます
妹に電話しましたが留守でした
音楽が止まって誰も動きませんでした
ラジオを消して寝ました
食卓を用意して待っていました
名古屋で乗り換えました
名前は忘れますが顔は忘れません
朝からずっと眼鏡を探していました
窓を開けたら鳥がいました
兄はラジオでニュースを読んでいました
その日の天気を覚えています
いい映画だけど悲しいと聞きました
膝のことで病院に行きました
困った時に助けてくれました
誕生日に弟に電話をかけました
稲刈りに誰も手伝いに来ませんでした
町で迷子になってお巡りさんに送ってもらいました
レコードをかけて二人で踊りました
昨日の夜、昔の映画を見ました
孫に歌を歌ってあげました
""",
}
SMALL_TALK = {language: lines.strip().split("\n") for language, lines in _LINES.items()}
