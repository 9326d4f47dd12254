"""What English speakers say when they answer a yes/no question."""

from languages.answer_book import AnswerBook, Says, make_phrases
from languages.tokens import WORDS, find_tokens, without_accents

_SELVES = "i|we|me|my|mine|im|ive|id"
_OTHERS = (
    "you|he|she|they|who|people|everyone|everybody|nobody|someone|somebody|wife|husband|mother"
    "|father|mum|dad|mom|son|daughter|sister|brother|friend|friends|children|grandchildren|grandson"
    "|granddaughter|grandmother|grandfather|doctor|doctors|neighbour|neighbours|kids|boys|girls|men"
    "|women|aunt|uncle|cousin|cousins|family|parents"
)
_PRONOUNS = "it|them|that|this|those|these|him|her|to"

#: "like my mother" is no opinion; "like it" is.
_DOUBTFUL = frozenset({"like", "liked"})

_TEXTS = {
    Says.LOVE: """
        love|loved|adore|adored|mad about|crazy about|passionate about|can't get enough
        |can't live without|couldn't live without|could not live without|can't resist|can't wait
        |couldn't love it more|nothing better|my favourite|my favorite|a great fan of
        |a big fan of|a huge fan|very fond|nothing I like better|nothing I like more
        |nothing I'd like more|never get tired of|never tire of|in love with|second to none
        |i'm a big fan|my passion|can't help loving|can't help but love|a great fan|a big fan
        |heaven|love nothing more
    """,
    Says.LIKE: """
        like|liked|enjoy|enjoyed|enjoying|fond of|fond|keen on|keen|a fan of|a fan|interested in
        |interested|partial to|feel like|wouldn't mind|would not mind|appreciate|wouldn't say no
        |would not say no|can't say no|care for|care about|looking forward|look forward to
        |think the world of|good at|fancy|into it|into that|enthusiastic
    """,
    Says.MILD: """
        don't mind|do not mind|dont mind|didn't mind|never minded|can't complain|cannot complain
        |it's all right|it's alright|they're all right|could be worse|have nothing against
        |nothing against|no objection|can take it or leave it|take it or leave it
    """,
    Says.DISLIKE: """
        dislike|disliked|not for me|not really for me|not quite for me|not exactly for me
        |isn't for me|aren't for me|not my cup of tea|isn't my cup of tea|not my thing
        |isn't my thing|never my thing|not my kind of thing|not my sort of thing|bores me
        |bored me|bored by|tired of|fed up|sick of|not a fan|no interest in|afraid of|scared of
        |go off|went off|gone off|off it|not up my street|couldn't care less|could not care less
        |don't see the point|not to my taste
    """,
    Says.HATE: """
        hate|hated|detest|detested|loathe|loathed|can't stand|cannot stand|cant stand
        |couldn't stand|can't bear|cannot bear|couldn't bear|could never stand|can't abide
        |cannot abide|never could stand|despise|hate the sight of|makes me sick|turns my stomach
    """,
    Says.DEPENDS: """
        so so|it depends|that depends|it all depends|depends on|depends|depending on|yes and no
        |depending|it varies|that varies|some days yes|on and off|in two minds|fifty fifty
        |when I'm in the mood|if I'm in the mood|some I do|some of them|some yes|half and half
    """,
    Says.YES: """
        yes|yeah|yea|yep|yup|aye|yes love|yes dear|yes please|sure|okay|ok|all right|alright
        |all right then|right you are|fine by me|please|please do|yes indeed|true|that's right
        |that's true|correct|me too|so do i|so did i|so have i|why not|go on|go on then|go ahead
        |with pleasure|by all means|my pleasure|I think so|I believe so|I'd say so
        |i would say so|I'd say yes|I think I do|I believe I do|I'm afraid I do|no problem
        |fair enough|if you like|if you want|if you please|don't mind if I do|doesn't everyone
        |doesn't everybody|let's|let us|let's do it|let's do that|gladly|happily|willingly
        |very well|will do|that would be nice|that'd be nice|that would be lovely
        |that'd be lovely|sounds good|sounds lovely|sounds nice|that sounds good
        |that sounds lovely|of an evening|always have|always did|always do|always
    """,
    Says.NO: """
        no|never have|nope|nah|nay|no love|no dear|no thanks|no thank you|not today|not now
        |not tonight|not just now|not at the moment|not right now|rather not|I'd rather not
        |i would rather not|I'd sooner not|I think not|I don't think so|i do not think so
        |don't think so|I doubt it|I'm afraid not|afraid not|I fear not|me neither|nor me
        |neither do I|nor do I|please don't|please no|don't bother|leave it|never mind
        |not this time|not any more|not anymore|I'd say no|I would say no|I should say not
        |I'd say not
    """,
    Says.SURE: """
        of course|of course I do|absolutely|definitely|certainly|indeed|rather|you bet|I'll say
        |and how|without a doubt|no doubt|naturally|obviously|not half|I should say so
        |I should think so|very much so|who doesn't|who does not|who wouldn't|how could I not
        |sure do|sure did|I certainly do|I certainly did|I most certainly do|I surely do
        |more than anything|with all my heart|too right|couldn't agree more|by golly
        |goodness yes|heavens yes|good heavens yes|oh my yes|oh yes|oh yeah|ooh yes
        |oh yes please|ooh yes please|every day|every single day|all the time|all my life
        |my whole life|hundred percent
    """,
    Says.NEVER: """
        not at all|at all|not in the least|not in the slightest|in the slightest|absolutely not
        |definitely not|certainly not|of course not|no way|no chance|not a chance|by no means
        |not on your life|not on your nelly|never ever|never in my life|not likely|not a bit
        |not one bit|not a bit of it|over my dead body|heavens no|good heavens no|goodness no
        |oh goodness no|good lord no|lord no|god no|anything but|not for the world
        |not for all the tea in china|perish the thought|under no circumstances|one bit
    """,
    Says.MEH: """
        not really|not much|not very|not very much|not a lot|not particularly|not especially
        |not so much|not too much|not exactly|not quite|not often|not very often|not always
        |hardly|not every day|hardly ever|hardly at all|barely|rarely|seldom|scarcely|not overly
        |not terribly|not massively|not hugely|not greatly|only a little|very little
        |not too keen|meh|not my favourite|not my favorite|not the best
        |could take or leave|no great fan|not a great fan|not a big fan|not a huge fan
        |not much of a fan|I prefer|I'd prefer|I would prefer|I'd rather|I would rather
        |maybe later|perhaps later|later perhaps|later maybe|another time|another day
        |some other time|maybe not|perhaps not|probably not|I suppose not|I guess not
        |not necessarily|not that much|not that keen|not if I can help it|nothing special
        |can't say I do|cannot say I do|can't say I have|can't say that I do|can't say I did
        |cannot say that I do|couldn't say I do|wouldn't say so|wouldn't say I do|not lately
        |not that I know of|not that I recall|used to but|not yet|not as much
    """,
    Says.ECHO: """
        I do|I did|I have|I would|I am|I was|I can|I could|I will|I shall|I'd|I might|we do
        |we did|we have|it is|it was|they are|they do|it does|it did|I should|I must|we would
    """,
    Says.GOOD: """
        lovely|wonderful|great|fantastic|marvellous|splendid|beautiful|delicious|tasty|nice
        |excellent|brilliant|super|fine|good|gorgeous|smashing|delightful|pleasant|fun|not bad
        |not bad at all|not too bad|not so bad|often|happy to|glad to|perfect|interesting|grand
        |nothing wrong|quite often|very often|many times|lots of times|once|twice|the best
        |a treat
    """,
    Says.BAD: """
        horrible|awful|terrible|boring|dreadful|disgusting|nasty|ugly|yuck|ugh|bad|rubbish
        |revolting|too noisy|too loud|too spicy|too sweet|too much for me|not good|not nice
        |no good|frightening|scary|tedious|dull|no fun|not fun|a waste of time|overrated
    """,
    Says.VERY: """
        very|very much|so much|a lot|lots|really|truly|dearly|immensely|enormously|hugely
        |greatly|especially|particularly|much|more than anything else|ever so much|ever so
        |too much|no end|such a lot|a great deal|terribly|awfully|extremely|deeply|all that much
        |that much|overly|most of all|totally|completely|thoroughly|a good deal|just
    """,
    Says.BIT: """
        a bit|a little|a little bit|a wee bit|a tad|somewhat|sort of|kind of|kinda|slightly
        |quite a bit less|I suppose so|I suppose|I guess so|I guess|I suppose I do|I guess I do
        |more or less|in a way|to some extent|up to a point|fairly|used to|when I was younger
        |not so much now|once upon a time|in moderation|a little less|OK I suppose|half
        |in small doses|just a little|just a bit|reasonably|I suppose I did|after a fashion
    """,
    Says.SOMETIMES: """
        sometimes|now and then|now and again|from time to time|once in a while
        |every now and then|every so often|occasionally|on occasion|at times|maybe|perhaps
        |possibly|it might|could be|might do|some days|on sundays|on a good day
        |only on special occasions|only sometimes|only when|in winter|in summer|probably
    """,
    Says.NOT: """
        not|don't|dont|do not|didn't|did not|haven't|have not|hadn't|wouldn't|would not|can't
        |cant|cannot|couldn't|could not|won't|isn't|wasn't|aren't|never|no longer|don't think I
        |do not think I|can't say I|cannot say I|can't say that I|couldn't say I|wouldn't say I
        |would not say I|wouldn't say that I|neither|nor|don't think|never did|never have been
        |don't suppose I|don't believe I|wouldn't exactly say I
    """,
    Says.NOT_NOT: """
        not that I don't|not that I do not|it's not that I don't|wouldn't say I don't
        |can't say I don't|couldn't say I don't|would not say I don't|it isn't that I don't
        |don't not|can't say that I don't|wouldn't say that I don't
    """,
    Says.THEIRS: """
        likes|loves|hates|enjoys|adores|dislikes|prefers|detests|doesn't|does not|doesnt
    """,
    Says.BUT: """
        but|although|though|however|except
    """,
    Says.ASIDE: """
        oh|well|ah|aah|um|uh|er|erm|hm|hmm|mm|mmm|ooh|eh|so|and|then|you know|I mean|honestly
        |actually|frankly|to be honest|to tell the truth|to tell you the truth|let me see
        |let me think|let's see|now|my dear|dear|darling|I must say|I must admit|I have to say
        |I have to admit|I can say|I say|I think|I believe|thank you|thanks|goodness
        |good heavens|heavens|bless you|gosh|my word|oh my|no idea|I don't know|I do not know
        |dont know|don't know|I'm not sure|not sure|I couldn't tell you|I couldn't say
        |can't remember|cannot remember|don't remember|I don't remember|do not remember
        |don't recall|no one|nobody|no matter|no wonder|no more than|what do you mean
        |I don't understand|not only|whether or not|if not|don't you|do you|you see|looks like
        |look like|sounds like|sound like|feels like|just like|something like|things like
        |is like|was like|were like|would like you|do|did|would|have|ve|m|am|s|d|ll|will|also
        |always been|always|still|both|quite|ever|been|there|any|any more|anymore|either|too|to
        |it|them|that|this|those|i|we|me|my|used|sir|madam|doctor|love you|must|think|myself
        |as well|be|being|never mind that|right|should|could
    """,
}

ENGLISH_ANSWERS = AnswerBook(
    make_phrases(_TEXTS, lambda text: find_tokens(text, WORDS), without_accents),
    selves=frozenset(_SELVES.split("|")),
    others=frozenset(_OTHERS.split("|")),
    pronouns=frozenset(_PRONOUNS.split("|")),
    doubtful=_DOUBTFUL,
)
