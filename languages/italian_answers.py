"""What Italian speakers say when they answer a yes/no question."""

from languages.answer_book import AnswerBook, Says, make_phrases
from languages.tokens import WORDS, find_tokens, without_accents

_PRONOUNS = "lo|la|li|le|ne|ci|quello|quella|quelli|questo|questa|così"
#: Not a yes before words we do not know: "certo che la guerra", "dai nonni", "sempre in campagna".
_DOUBTFUL = "si|sicuro|certo|vero|dai|già|gia|giusto|sempre"

_TEXTS = {
    Says.LOVE: """
        adoro|adoravo|adorerei|amo|amavo|ho amato|l'ho amato|l'ho amata|ho sempre amato
        |ho sempre adorato|mi fa impazzire|mi fanno impazzire|vado matto|vado matta|vado pazzo
        |vado pazza|ne vado matto|ne vado matta|ne vado pazzo|ne vado pazza|andavo matto
        |andavo matta|vado ghiotto|vado ghiotta|ne sono ghiotto|ne sono ghiotta|sono innamorato
        |sono innamorata|la mia passione|una mia passione|la mia vita|il mio preferito
        |la mia preferita|i miei preferiti|le mie preferite|è il massimo|non vedo l'ora
        |non posso farne a meno|non ne posso fare a meno|non ne potrei fare a meno
        |non potrei farne a meno|ne vado fiero|non potrei vivere senza|non posso vivere senza
        |non c'è niente di meglio|niente di meglio|mi entusiasma|mi entusiasmano|mi appassiona
        |mi appassionano|mi incanta|mi fa sognare|ne sono entusiasta|sono un grande appassionato
        |sono una grande appassionata|mi riempie di gioia|mi riempiono di gioia
        |mi scalda il cuore|la fine del mondo|è la vita mia
    """,
    Says.LIKE: """
        mi piace|mi piacciono|mi piaceva|mi piacevano|mi è piaciuto|mi è piaciuta
        |mi sono piaciuti|mi sono piaciute|mi è sempre piaciuto|mi è sempre piaciuta
        |mi sono sempre piaciuti|mi sono sempre piaciute|mi è mai piaciuto|mi è mai piaciuta
        |mi sono mai piaciuti|mi sono mai piaciute|mi piacque|mi piacerebbe|mi piacerebbero
        |mi sarebbe piaciuto|mi piacerà|mi piaccia|mi piacciano|mi piacesse|me piace
        |me piacciono|mi garba|mi garbano|mi aggrada|mi interessa|mi interessano|mi interessava
        |mi diverte|mi divertono|mi diverto|mi divertivo|mi diverte molto|mi va|mi andrebbe
        |mi attira|mi attirano|mi fa piacere|mi farebbe piacere|mi farà piacere|ne ho voglia
        |ho voglia|ne avrei voglia|avrei voglia|apprezzo|apprezzavo|gradisco|gradirei
        |sono appassionato|sono appassionata|ci piace|ci piacciono|mi sta simpatico
        |mi stanno simpatici|mi rilassa|mi rilassano|mi fa bene|mi fa stare bene|gli voglio bene
        |mi è gradito|mi trovo bene|mi mette allegria|mi mettono allegria|mi ispira|mi affascina
        |mi affascinano|mi tenta
    """,
    Says.MILD: """
        non mi dispiace|non mi dispiacciono|non mi dispiaceva|non mi dispiacevano
        |non mi è dispiaciuto|non mi è dispiaciuta|non ho niente contro|non ho nulla contro
        |si lascia mangiare|si lascia bere|si lascia ascoltare|si lascia guardare
        |mi è indifferente|mi sono indifferenti|mi lascia indifferente
        |non mi fa né caldo né freddo|mi fa né caldo né freddo|non mi dà fastidio
        |non mi danno fastidio|non disdegno|non lo disdegno
    """,
    Says.DISLIKE: """
        mi annoia|mi annoiano|mi annoiava|mi annoiavano|mi annoio|mi stufa|mi stufano
        |mi sono stufato|mi sono stufata|sono stufo|sono stufa|mi sono stancato|mi sono stancata
        |non fa per me|non fanno per me|non faceva per me|mi dà fastidio|mi danno fastidio
        |mi dava fastidio|mi stanca|mi stancano|non è roba per me|non è cosa per me
        |non è il mio genere|non è il mio forte|mi resta sullo stomaco|mi resta pesante
        |mi fa paura|mi fanno paura|ho paura|mi fa tristezza|mi mette tristezza|mi lascia freddo
        |mi lascia fredda|non me ne importa|non mi importa|non m'importa|non me ne frega
        |non mi dice niente|non mi dicono niente|non mi dice nulla|non sono portato
        |non sono portata|non è per me|mi sta antipatico|mi stanno antipatici|non è di mio gusto
    """,
    Says.HATE: """
        odio|odiavo|detesto|detestavo|ho sempre odiato|ho sempre detestato|non sopporto
        |non lo sopporto|non la sopporto|non li sopporto|non le sopporto|non sopportavo
        |non lo sopportavo|non la sopportavo|non ho mai sopportato|non l'ho mai sopportato
        |non l'ho mai sopportata|non posso soffrire|non lo posso soffrire|non la posso soffrire
        |non posso vedere|non lo posso vedere|non la posso vedere|non li posso vedere
        |non le posso vedere|mi fa schifo|mi fanno schifo|mi faceva schifo|che schifo
        |mi fa orrore|mi fa ribrezzo|mi disgusta|mi disgustano|mi ripugna|mi fa venire la nausea
        |che orrore
    """,
    Says.DEPENDS: """
        dipende|dipende dai giorni|dipenderebbe|dipendeva|a seconda|secondo i giorni
        |secondo i momenti|secondo come mi sento|secondo l'umore|sì e no|né sì né no|ni
        |un giorno sì e uno no|un po' sì e un po' no|un po' sì un po' no
        |certe volte sì certe volte no|a volte sì e a volte no|a volte sì a volte no
        |alcuni sì altri no|alcune sì altre no|se ne ho voglia|se sono dell'umore
        |quando ne ho voglia|quando mi va|se mi va|se mi gira
    """,
    Says.YES: """
        sì certo|sì sì|sì sì certo|sì|si|ma sì|eh sì|beh sì|sissignore|certo|certamente|sicuro
        |sicuramente|d'accordo|va bene|va benissimo|volentieri|perché no|e perché no|ok|okay
        |okey|dai|magari|penso di sì|credo di sì|direi di sì|mi sa di sì|mi pare di sì
        |mi sembra di sì|spero di sì|suppongo di sì|esatto|già|con piacere|ci sto|benissimo
        |perfetto|facciamo|proviamo|prego|per favore|per piacere|grazie sì|sì grazie|è vero
        |giusto|hai ragione|anch'io|anche a me|anche io|a me sì|io sì|fai pure|faccia pure
        |come vuoi|come vuole|se vuoi|se vuole|ben volentieri|vero|di sì|quello sì|questo sì
        |sempre|con molto piacere|mi farebbe comodo|ci mancherebbe
    """,
    Says.NO: """
        no|ma no|eh no|beh no|nossignore|no grazie|grazie no|penso di no|credo di no|direi di no
        |mi sa di no|mi pare di no|mi sembra di no|temo di no|spero di no|purtroppo no|adesso no
        |ora no|oggi no|stasera no|per ora no|per adesso no|non ora|non adesso|non oggi
        |non stasera|a me no|io no|neanch'io|neanche io|nemmeno io|neppure io|neanche a me
        |nemmeno a me|magari no|di no|no no|quello no|questo no|lascia stare|lasciamo stare
        |lascia perdere|lasciamo perdere|meglio di no|è meglio di no|preferisco di no
        |preferirei di no|non importa|non serve|non occorre|mai provato|mai provata|mai visto
        |mai vista|mai stato|mai stata|mai sentito|mai sentita|mai fatto|macché|ma che
    """,
    Says.SURE: """
        eccome|altroché|altro che|certo che sì|come no|assolutamente|assolutamente sì|ovviamente
        |ovvio|naturalmente|ma certo|ma certo che sì|certo certo|senz'altro|sicurissimo
        |sicurissima|e chi non|a chi non piace|a chi non piacciono|ci puoi giurare
        |ci può giurare|e come|figurati se no|molto volentieri|più che volentieri|si capisce
        |sicuro che sì|oh sì|oh sì sì|eh sì certo|proprio sì|sì eccome|sì altroché|di sicuro
        |e me lo chiedi|che domande|che domanda|con tutto il cuore|più di ogni altra cosa
        |non sai quanto|non sa quanto|da sempre|tutti i giorni|ogni giorno|tutta la vita
        |e come no|di certo|certo che mi piace|certo che mi piacciono|certo che mi va
        |cento per cento
    """,
    Says.NEVER: """
        per niente|per nulla|niente affatto|affatto|nient'affatto|assolutamente no|certo che no
        |certamente no|no di certo|no di sicuro|sicuramente no|proprio no|no proprio|proprio non
        |davvero non|veramente non|neanche per sogno|nemmeno per sogno|neppure per sogno
        |neanche per idea|nemmeno per idea|mai e poi mai|neanche un po'|nemmeno un po'
        |neppure un po'|ma va|ma va là|ma figurati|figuriamoci|neanche a pagarmi|neanche morto
        |neanche morta|per carità|per l'amor del cielo|per l'amor di dio|in nessun modo
        |in nessun caso|ma neanche un po'|manco per sogno|manco per niente|zero
        |ma nemmeno un po'|dio ce ne scampi|non se ne parla|ma quando mai|manco morto
        |manco morta|neanche lontanamente|assolutamente per niente
    """,
    Says.MEH: """
        non tanto|non molto|non troppo|non proprio|non particolarmente|non granché
        |non un granché|non più di tanto|mica tanto|mica molto|mica troppo|poco|pochino
        |un pochino poco|pochissimo|molto poco|poco poco|quasi mai|raramente|di rado|mah|bah
        |mah insomma|insomma|preferisco|preferirei|non sempre|non spesso|non tutti i giorni
        |non ogni giorno|non ancora|non esattamente|non in modo particolare|non è che
        |niente di che|niente di speciale|niente di particolare|magari dopo|magari più tardi
        |magari domani|magari un'altra volta|magari un altro giorno|un'altra volta
        |un altro giorno|dopo|più tardi|forse dopo|forse più tardi|forse domani|forse no
        |più no che sì|non eccessivamente|non saprei dire di sì|non direi|non mi pare
        |non mi sembra|non più|così e così|non me ne intendo|non necessariamente|non per forza
        |il meno possibile|non abbastanza|non in particolare|non eccelso|si e no
    """,
    Says.ECHO: """
        vorrei|lo vorrei|la vorrei|lo vorrei tanto|ce l'ho|l'ho fatto|l'ho fatta|l'ho visto
        |l'ho vista|l'ho provato|l'ho provata|ci sono stato|ci sono stata|ci sono andato
        |ci sono andata|lo faccio|la faccio|lo so|lo so fare|mi è capitato|mi capita|mi capitava
        |lo conosco|la conosco|li conosco|le conosco|me lo ricordo|me la ricordo|mi ricordo
        |lo ricordo|la ricordo|lo mangio|lo bevo|la bevo|la mangio|lo facevo|la facevo|lo guardo
        |la guardo|lo ascolto|la ascolto|li ho visti|le ho viste|lo festeggio|lo festeggiamo
        |lo festeggiavamo|ne ho avuto uno|ne ho avuta una
    """,
    Says.GOOD: """
        bello|bella|belli|belle|bellissimo|bellissima|bellissimi|bellissime|buono|buona|buoni
        |buone|buonissimo|buonissima|buonissimi|buonissime|squisito|squisita|squisiti|squisite
        |delizioso|deliziosa|ottimo|ottima|ottima idea|buona idea|bella idea|che bello|che bella
        |che bella idea|che buono|che buona|che buoni|che buone|che meraviglia|meraviglioso
        |meravigliosa|meravigliosi|meravigliose|stupendo|stupenda|splendido|splendida|fantastico
        |fantastica|magnifico|magnifica|interessante|interessanti|divertente|divertenti|spesso
        |mica male|non male|non è male|non sono male|non c'è male|niente male|tante volte
        |molte volte|una volta sola|più volte|piacevole|piacevoli|gradevole|carino|carina|bene
        |spettacolare|una meraviglia|una delizia|il meglio|sarebbe bello|sarebbe bellissimo
    """,
    Says.BAD: """
        brutto|brutta|brutti|brutte|cattivo|cattiva|orribile|orribili|orrendo|orrenda|terribile
        |noioso|noiosa|noiosi|noiose|pesante|pesanti|che noia|una noia|che barba|disgustoso
        |disgustosa|schifoso|schifosa|insopportabile|troppo rumoroso|troppo forte
        |troppo piccante|troppo dolce|troppo difficile|troppo faticoso|fatica|una fatica
        |una perdita di tempo|che paura|una tortura|antipatico|antipatici|che fatica
    """,
    Says.VERY: """
        molto|moltissimo|tanto|tantissimo|un sacco|da morire|da matti|davvero|veramente|assai
        |parecchio|un mondo|troppo|moltissime|molto molto|tanto tanto|alla follia|più di tutto
        |più di tutti|particolarmente|infinitamente|enormemente|immensamente|un casino|una cifra
        |tantissime|soprattutto|specialmente|granché|più di tanto|un granché
        |eccessivamente
    """,
    Says.BIT: """
        un po'|un po|un poco|un pochino|un pochettino|un tantino|appena appena|abbastanza
        |discretamente|così così|più o meno|una volta|una volta sì|un tempo|un tempo sì
        |da giovane|da giovani|prima sì|tutto sommato|in fondo|direi abbastanza|benino
        |benino dai|quanto basta|diciamo di sì|diciamo|mezzo e mezzo|ma poco|un pezzetto
        |un assaggino|a piccole dosi
    """,
    Says.SOMETIMES: """
        a volte|alle volte|qualche volta|certe volte|ogni tanto|talvolta|ogni tanto sì
        |di tanto in tanto|di quando in quando|saltuariamente|forse|forse sì|può darsi
        |può essere|chissà|probabilmente|alcune volte|la domenica|solo la domenica|solo a natale
        |d'estate|d'inverno|in estate|in inverno|quando capita|se capita|raramente ma sì
        |certi giorni
    """,
    Says.NOT: """
        non|mica|né|nemmeno|neanche|neppure|mai|non è mai|non è che mi|no che non|nessuno
        |nessuna|non ci sono mai|non ho mai
    """,
    Says.NOT_NOT: """
        non è che non|non posso dire che non|non direi che non|non si può dire che non
    """,
    Says.THEIRS: """
        piace|piaceva|piacciono|piacevano|piacque|adora|adorava|odia|odiava|detesta|detestava
        |ama|amava|ti piace|ti piacciono|gli piace|gli piacciono|le piace|le piacciono|vi piace
        |a te piace|gli piaceva|le piaceva|gli piacevano|le piacevano|si piace
    """,
    Says.BUT: """
        ma|però|anche se|tranne|eppure|solo che
    """,
    Says.ASIDE: """
        certo che|oh|eh|ah|beh|be|bè|ehm|uhm|mmm|mm|uh|uffa|allora|ecco|senti|guarda|sai|vedi
        |cara|caro|tesoro|gioia|figlio mio|figlia mia|signore|signora|signorina|grazie
        |grazie mille|ti ringrazio|la ringrazio|mi dispiace|mi spiace|scusa|scusi|purtroppo
        |per fortuna|dico|devo dire|devo dire che|devo ammettere|a dire il vero|a dir la verità
        |a dire la verità|per dire la verità|per la verità|sinceramente|onestamente|francamente
        |in verità|secondo me|per me|a me|io|me|mi|noi|proprio|lo|la|li|le|ne|ci|gli|è|e|sono|ho
        |stato|stata|di|che|sempre|direi|credo|penso|boh|non lo so|non so|non saprei
        |non saprei dire|non ricordo|non mi ricordo|non me lo ricordo|non me la ricordo
        |chi lo sa|non capisco|non ho capito|come hai detto|come ha detto|non so se|ancora|anche
        |pure|adesso|ora|oggi|mio dio|madonna|mamma mia|accidenti|tutto|quello|questo|quelli
        |quella|più|piaciuto|piaciuta|del tutto|in effetti
    """,
}

ITALIAN_ANSWERS = AnswerBook(
    make_phrases(_TEXTS, lambda text: find_tokens(text, WORDS), without_accents),
    pronouns=frozenset(_PRONOUNS.split("|")),
    doubtful=frozenset(_DOUBTFUL.split("|")),
)
