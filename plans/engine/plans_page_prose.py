"""The parts of docs/plans.md that no table can say."""

HEAD = """\
# Plans

What a client gets to do, and what people say to get it. This page is written from the published
content by `make plans`; a test compares it with the content. Calls: [api.md](api.md); clients that
speak to `/CAIR_hub`: [compatibility.md](compatibility.md).

On each turn: say `plan_sentence`, do the actions of `plan` one after another, then say
`dialogue_sentence`. All three may be empty.

## The plan string

```
plan    = "" | 1*( "#action=" NAME *( " " KEY "=" VALUE ) )
NAME    = 1*( letter | digit | "_" )        KEY = lower-case word
VALUE   = one word | free text (only as the last value of an item) | "None" (nobody said it)
```

| plan | |
| --- | --- |
| `#action=playsong title=Hey Brother` | one action; its text goes to the end of the item |
| `#action=playsong title=None` | the person named no song |
| `#action=translate language=italian what=good morning` | words first, the text last |
| `#action=goto where=docking station#action=rest` | two actions, one after the other |

What holds of every plan:

- every parameter of an action is there, in the order of the table below, `None` where nobody said
  it;
- free text comes last, at most one an action; word parameters are single ASCII words;
- no value holds `#` or a line break, and no blank stands before the next `#`.
"""

READING = """\
### Reading it

`plan_actions` is the same as JSON, with `null` for `None`. Who has the string only:

```python
# The names are in the table below and in GET /api/v1/actions/.
PARAMETERS = {"playsong": ["title"], "translate": ["language", "what"], "hug": []}


def read_plan(plan):
    \"\"\"Return the actions in their order, each with its parameters; None: nobody said it.\"\"\"
    actions = []
    for item in plan.split("#action=")[1:]:
        name, _, rest = item.partition(" ")
        if name not in PARAMETERS:
            continue  # A newer action: skip what you do not know.
        parts = rest.split(" ", len(PARAMETERS[name]) - 1) if rest else []
        pairs = [part.split("=", 1) for part in parts]
        actions.append((name, {key: None if text == "None" else text for key, text in pairs}))
    return actions
```

A client that names its actions in `capabilities` gets no others: the agent then says politely that
it cannot do that.
"""

ACTIONS_INTRO = """\
## The actions of clients

A *word* is one of the words in brackets, or any single word where none are named; a *text* is
what the person said.
"""

KB_INTRO = """
## The actions of KBplans

They act on the talk. The Hub hands them to the Dialogue Manager; a client does nothing.
"""

INTENTS_INTRO = """
## The intents

What people can ask for, by family. The intent of the highest priority wins, then the one with the
most words of its own. In triggers, `[x]` may be left out, `(a|b)` is one of these, `<x>` a
[phrase](#phrases) and `{x}` a parameter. Where a required parameter is missing the agent asks for
it, and the plan comes with the answer.
"""
