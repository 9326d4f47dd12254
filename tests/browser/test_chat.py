"""The web chat as people use it: with a mouse, a keyboard, a voice, old eyes, a bad connection."""

import re
from typing import Any

import pytest
from playwright.sync_api import BrowserContext, Locator, Page, Route, expect

pytestmark = pytest.mark.browser

HUB = "**/api/v1/hub/**"
DARK = {"color_scheme": "dark"}
NARROW = {"viewport": {"width": 320, "height": 640}}
DESK = {"viewport": {"width": 1440, "height": 900}}

# A browser whose voice and ear are played by this script.
PLAYED_VOICE = """
window.said = [];
const voices = [{lang: "en-GB", name: "Ann", localService: true}];
const mouth = new EventTarget();
Object.assign(mouth, {getVoices: () => voices, cancel() {}, speak: (one) => said.push(one)});
Object.defineProperty(window, "speechSynthesis", {value: mouth});
window.SpeechSynthesisUtterance = function (text) { this.text = text; };
window.SpeechRecognition = function () { window.ear = this; this.start = this.stop = () => {}; };
"""
NO_VOICE = """
Object.defineProperty(window, "speechSynthesis", {value: undefined});
Object.defineProperty(window, "SpeechRecognition", {value: undefined});
Object.defineProperty(window, "webkitSpeechRecognition", {value: undefined});
"""
# Text whose contrast with the colour behind it is below 7:1.
PALE_TEXT = """() => {
  const numbers = (colour) => colour.match(/[\\d.]+/g).map(Number);
  const light = ([r, g, b]) => [r, g, b].map((part) => part / 255)
    .map((part) => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4))
    .reduce((sum, part, index) => sum + part * [0.2126, 0.7152, 0.0722][index], 0);
  const behind = (node) => {
    const colour = numbers(getComputedStyle(node).backgroundColor);
    return colour[3] === 0 ? behind(node.parentElement) : colour;
  };
  const contrast = (node) => {
    const [one, other] = [numbers(getComputedStyle(node).color), behind(node)].map(light);
    return (Math.max(one, other) + 0.05) / (Math.min(one, other) + 0.05);
  };
  const own = (node) => [...node.childNodes].some(({data}) => data?.trim());
  const shown = (node) => node.checkVisibility() && getComputedStyle(node).fontSize !== "0px";
  return [...document.body.querySelectorAll("*")]
    .filter((node) => shown(node) && own(node))
    .filter((node) => contrast(node) < 7)
    .map((node) => `${node.textContent.slice(0, 40)}: ${contrast(node).toFixed(1)}`);
}"""
# What can be touched but is smaller than 44 x 44 pixels, or has no name.
BAD_CONTROLS = """() => [
  ...document.querySelectorAll("button, summary, textarea, label.switch, .pill, a")
].filter((node) => node.checkVisibility() && !node.matches(".skip"))
  .filter((node) => {
    const {width, height} = node.getBoundingClientRect();
    const name = node.ariaLabel || node.textContent.trim() || node.labels?.[0]?.textContent;
    return width < 44 || height < 44 || !name;
  }).map((node) => node.outerHTML)"""


def begin(page: Page, language: str = "en", address: str = "/") -> Locator:
    """Start a talk and return the log."""
    page.goto(address)
    page.locator(f"input[name=language][value={language}]").check()
    page.locator("#start").click()
    page.locator(".reply").first.wait_for()
    return page.get_by_role("log")


def tell(page: Page, sentence: str) -> Locator:
    """Say a sentence and return the reply."""
    before = page.locator(".reply").count()
    page.locator("#sentence").fill(sentence)
    page.locator("#sentence").press("Enter")
    answer = page.locator(".reply").nth(before)
    answer.wait_for()
    return answer


def refuse(page: Page, status: int, code: str) -> None:
    """Let every turn fail like this."""
    error = {"code": code, "message": "The message.", "hint": "The hint."}

    def answer(route: Route) -> None:
        if route.request.method == "POST":
            route.fulfill(status=status, json={"error": error})
        else:
            route.continue_()

    page.route(HUB, answer)


@pytest.mark.parametrize(
    ("language", "tag", "start"),
    [("en", "en", "Let us talk"), ("it", "it", "Parliamo"), ("ja", "ja", "話を始める")],
)
def test_the_page_speaks_the_chosen_language(
    page: Page, language: str, tag: str, start: str
) -> None:
    page.goto("/")
    page.locator(f"input[name=language][value={language}]").check()
    expect(page.locator("#start")).to_have_text(start)
    expect(page.locator("html")).to_have_attribute("lang", re.compile(f"^{tag}"))
    page.locator("#start").click()
    expect(page.locator(".reply .bubble")).to_have_attribute("lang", re.compile(f"^{tag}"))
    expect(page.locator(".reply .bubble")).not_to_be_empty()


def test_the_culture_follows_the_language_and_can_be_chosen(page: Page) -> None:
    page.goto("/")
    page.locator("input[name=language][value=it]").check()
    expect(page.locator("input[name=culture][value=IT]")).to_be_checked()
    page.locator("input[name=culture][value=JP]").check()
    with page.expect_request(re.compile("language=it&culture=JP")):
        page.locator("#start").click()


def test_a_turn_shows_both_sentences(page: Page) -> None:
    log = begin(page)
    answer = tell(page, "Yes, I do!")
    expect(log.locator(".yours .bubble")).to_have_text("Yes, I do!")
    expect(answer.locator(".dialogue-sentence")).not_to_be_empty()
    expect(page.locator("#sentence")).to_have_value("")


def test_a_request_shows_the_plan_between_the_sentences(page: Page) -> None:
    begin(page)
    answer = tell(page, "play the song Hey Brother")
    expect(answer.locator(".plan code")).to_have_text("playsong")
    expect(answer.locator(".plan dt")).to_have_text("title")
    expect(answer.locator(".plan dd")).to_have_text(re.compile("Hey Brother", re.IGNORECASE))
    parts = answer.locator("> .bubble, > .plan")
    kinds = parts.evaluate_all("parts => parts.map((part) => part.className)")
    assert kinds[:2] == ["bubble plan-sentence", "plan"]


def test_why_this_reply_tells_the_rules_of_the_very_reply(page: Page) -> None:
    begin(page)
    answer = tell(page, "Yes, I like it very much.")
    answer.locator(".why summary").click()
    expect(answer.locator(".steps > li").first).to_be_visible()
    expect(answer.locator(".rule").first).not_to_be_empty()
    expect(answer.locator(".notes")).not_to_contain_text("Asked again")


def test_a_reload_keeps_the_talk_and_welcomes_back(page: Page) -> None:
    begin(page)
    tell(page, "I had a lovely garden.")
    page.reload()
    expect(page.locator(".yours .bubble")).to_have_text("I had a lovely garden.")
    expect(page.locator(".reply")).to_have_count(3)
    page.reload()
    page.wait_for_load_state("networkidle")
    expect(page.locator(".reply")).to_have_count(3)


def test_a_half_written_sentence_survives_a_reload(page: Page) -> None:
    begin(page)
    page.locator("#sentence").fill("When I was a")
    page.reload()
    expect(page.locator("#sentence")).to_have_value("When I was a")


def test_start_again_asks_before_it_deletes(page: Page) -> None:
    begin(page)
    page.locator("#open-settings").click()
    page.locator("#again").click()
    expect(page.get_by_role("dialog")).to_be_visible()
    page.get_by_role("button", name="No, keep talking").click()
    expect(page.locator(".reply")).to_have_count(1)
    assert page.evaluate("localStorage['cair.talk']")


def test_start_again_deletes_the_talk(page: Page) -> None:
    begin(page)
    page.locator("#open-settings").click()
    page.locator("#again").click()
    page.get_by_role("button", name="Yes, delete it").click()
    expect(page.locator("#welcome")).to_be_visible()
    expect(page.locator("#welcome-title")).to_be_focused()
    assert page.evaluate("localStorage['cair.talk']") is None
    page.reload()
    expect(page.locator("#welcome")).to_be_visible()


def test_a_lost_connection_loses_no_text(page: Page, context: BrowserContext) -> None:
    begin(page)
    context.set_offline(True)
    page.locator("#sentence").fill("I love the sea.")
    page.locator("#sentence").press("Enter")
    expect(page.get_by_role("alert").get_by_text("I cannot reach the server")).to_be_visible()
    expect(page.locator("#sentence")).to_have_value("I love the sea.")
    context.set_offline(False)
    page.get_by_role("button", name="Try again").click()
    expect(page.locator(".reply")).to_have_count(2)
    expect(page.locator(".yours")).to_have_count(1)


@pytest.mark.parametrize(
    ("status", "code", "words"),
    [
        (413, "body.too_large", "fewer words"),
        (429, "busy", "wait a little"),
        (503, "content.not_published", "nobody has published"),
        (400, "body.invalid", "in another way"),
        (500, "server.error", "on my side"),
    ],
)
def test_an_error_is_told_kindly(page: Page, status: int, code: str, words: str) -> None:
    begin(page)
    refuse(page, status, code)
    page.locator("#sentence").fill("Good morning!")
    page.locator("#send").click()
    alert = page.locator("#talk-trouble")
    expect(alert).to_contain_text(words)
    expect(page.locator("#sentence")).to_have_value("Good morning!")
    alert.locator("summary").click()
    expect(alert.locator(".told")).to_have_text(f"{code} · The message. · The hint.")


def test_a_damaged_state_leads_to_a_new_thread(page: Page) -> None:
    begin(page)
    refuse(page, 400, "state.damaged")
    page.locator("#sentence").fill("Good morning!")
    page.locator("#send").click()
    page.get_by_role("button", name="Pick up a new thread").click()
    expect(page.locator(".reply")).to_have_count(2)
    expect(page.locator("#sentence")).to_have_value("Good morning!")


def test_an_error_at_the_start_can_be_tried_again(page: Page) -> None:
    page.goto("/")
    page.route(HUB, lambda route: route.abort())
    page.locator("#start").click()
    expect(page.locator("#welcome-trouble")).to_contain_text("I cannot reach the server")
    page.unroute(HUB)
    page.get_by_role("button", name="Try again").click()
    expect(page.locator(".reply")).to_have_count(1)


def test_a_seed_in_the_address_repeats_a_talk(page: Page) -> None:
    with page.expect_request(re.compile(r"hub/\?.*seed=7$")):
        begin(page, address="/?seed=7")
    first = tell(page, "Yes!").inner_text()
    page.evaluate("localStorage.clear()")
    begin(page, address="/?seed=7")
    assert tell(page, "Yes!").inner_text() == first


def test_nothing_is_fetched_from_elsewhere_and_no_policy_broken(
    page: Page, live_server: Any
) -> None:
    complaints: list[str] = []
    addresses: list[str] = []
    page.on("console", lambda message: complaints.append(message.text))
    page.on("pageerror", lambda error: complaints.append(str(error)))
    page.on("request", lambda request: addresses.append(request.url))
    begin(page)
    tell(page, "play the song Hey Brother").locator(".why summary").click()
    page.locator(".steps").wait_for()
    assert complaints == []
    assert [one for one in addresses if not one.startswith(live_server.url)] == []


def test_the_page_carries_a_strict_policy(page: Page) -> None:
    answer = page.goto("/")
    assert answer is not None
    policy = answer.headers["content-security-policy"]
    assert "default-src 'self'" in policy
    assert "unsafe" not in policy


def test_markup_in_a_sentence_stays_text(page: Page) -> None:
    begin(page)
    tell(page, "<img src=x onerror=alert(1)>")
    expect(page.locator(".yours .bubble")).to_have_text("<img src=x onerror=alert(1)>")
    expect(page.locator("#log img")).to_have_count(0)


@pytest.mark.parametrize("options", [DESK])
def test_a_whole_talk_works_with_the_keyboard_alone(page: Page) -> None:
    page.goto("/")
    page.locator("input[name=language]:checked").focus()
    page.keyboard.press("ArrowRight")
    page.keyboard.press("Tab")
    page.keyboard.press("Tab")
    expect(page.locator("#start")).to_be_focused()
    page.keyboard.press("Enter")
    page.locator(".reply").wait_for()
    page.locator("#sentence").focus()
    page.keyboard.type("Buongiorno!")
    page.keyboard.press("Enter")
    expect(page.locator(".reply")).to_have_count(2)
    expect(page.locator("#sentence")).to_be_focused()


def test_the_focus_can_be_seen(page: Page) -> None:
    page.goto("/")
    page.keyboard.press("Tab")
    outline = page.evaluate("getComputedStyle(document.activeElement).outlineWidth")
    assert float(outline.removesuffix("px")) >= 3


def test_enter_that_confirms_a_japanese_word_sends_nothing(page: Page) -> None:
    begin(page, "ja")
    page.locator("#sentence").fill("おちゃ")
    page.locator("#sentence").dispatch_event("keydown", {"key": "Enter", "isComposing": True})
    page.locator("#sentence").dispatch_event("keydown", {"key": "Enter", "shiftKey": True})
    expect(page.locator(".yours")).to_have_count(0)
    expect(page.locator("#sentence")).to_have_value("おちゃ")


def test_the_log_is_announced_politely_but_old_lines_are_not(page: Page) -> None:
    log = begin(page)
    expect(log).to_have_attribute("aria-live", "polite")
    tell(page, "Yes!")
    page.reload()
    expect(log).to_have_attribute("aria-live", "off")
    expect(log).to_have_attribute("aria-live", "polite")


@pytest.mark.parametrize("options", [{}, DESK, NARROW])
def test_every_control_is_large_and_has_a_name(page: Page) -> None:
    page.add_init_script(PLAYED_VOICE)
    page.goto("/")
    assert page.evaluate(BAD_CONTROLS) == []
    begin(page)
    tell(page, "play the song Hey Brother")
    page.evaluate("document.getElementById('settings').classList.add('open')")
    assert page.evaluate(BAD_CONTROLS) == []


@pytest.mark.parametrize("options", [{}, DARK, DESK, DARK | DESK])
def test_all_text_has_a_contrast_of_seven_to_one(page: Page) -> None:
    page.add_init_script(PLAYED_VOICE)
    page.goto("/")
    assert page.evaluate(PALE_TEXT) == []
    begin(page)
    tell(page, "play the song Hey Brother").locator(".why summary").click()
    page.locator(".steps").wait_for()
    refuse(page, 413, "body.too_large")
    page.locator("#sentence").fill("Too long")
    page.locator("#send").click()
    page.locator(".trouble summary").click()
    page.wait_for_timeout(400)  # until the last line has faded in
    assert page.evaluate(PALE_TEXT) == []


@pytest.mark.parametrize("options", [NARROW, {}, DESK])
@pytest.mark.parametrize("language", ["en", "it", "ja"])
def test_the_largest_letters_never_scroll_sideways(page: Page, language: str) -> None:
    sideways = "document.documentElement.scrollWidth - document.documentElement.clientWidth"
    page.goto("/")
    for _ in range(3):
        page.locator("#larger").click()
    expect(page.locator("#larger")).to_be_disabled()
    assert page.evaluate(sideways) == 0
    begin(page, language)
    tell(page, "play the song Hey Brother").locator(".why summary").click()
    page.locator(".steps").wait_for()
    assert page.evaluate(sideways) == 0


def test_the_size_of_the_letters_is_remembered(page: Page) -> None:
    size = "parseFloat(getComputedStyle(document.documentElement).fontSize)"
    page.goto("/")
    assert page.evaluate(size) == 20
    page.get_by_role("button", name="Larger letters").click()
    assert page.evaluate(size) > 20
    expect(page.get_by_role("status")).to_have_text("Letter size 3 of 5")
    page.reload()
    page.locator("#welcome").wait_for()
    assert page.evaluate(size) > 20


@pytest.mark.parametrize("options", [{"reduced_motion": "reduce"}])
def test_nothing_moves_for_those_who_want_calm(page: Page) -> None:
    begin(page)
    tell(page, "Yes!")
    assert page.evaluate("document.getAnimations().length") == 0


def test_without_the_speech_api_there_are_no_voice_settings(page: Page) -> None:
    page.add_init_script(NO_VOICE)
    begin(page)
    page.locator("#open-settings").click()
    for place in ("#voice", "#listen", "#hush", ".hear"):
        expect(page.locator(place).first).to_be_hidden()


def test_voice_and_microphone_are_off_at_first(page: Page) -> None:
    page.add_init_script(PLAYED_VOICE)
    begin(page)
    page.locator("#open-settings").click()
    for name in ("Read replies aloud", "Speak slowly", "Talk with the microphone"):
        expect(page.get_by_role("switch", name=name)).not_to_be_checked()
    expect(page.locator("#listen")).to_be_hidden()
    assert page.evaluate("said.length") == 0


def test_replies_are_read_aloud_slowly_when_wished(page: Page) -> None:
    page.add_init_script(PLAYED_VOICE)
    begin(page)
    page.locator("#open-settings").click()
    page.get_by_role("switch", name="Read replies aloud").check()
    page.get_by_role("switch", name="Speak slowly").check()
    shown = " ".join(tell(page, "Yes!").locator(".bubble").all_inner_texts())
    spoken = page.evaluate("said.map((one) => one.text).join(' ')")
    assert spoken.split() == shown.split()
    assert page.evaluate("said[0].rate") < 0.8
    assert page.evaluate("said[0].lang") == "en-GB"


def test_a_language_without_a_voice_says_so(page: Page) -> None:
    page.add_init_script(PLAYED_VOICE)
    begin(page, "ja")
    page.locator("#open-settings").click()
    expect(page.locator("#aloud")).to_be_disabled()
    expect(page.locator("#no-voice")).to_contain_text("日本語")


def test_the_microphone_silences_the_robot_and_what_is_heard_is_sent(page: Page) -> None:
    page.add_init_script(PLAYED_VOICE)
    begin(page)
    page.locator("#open-settings").click()
    page.get_by_role("switch", name="Read replies aloud").check()
    page.get_by_role("switch", name="Talk with the microphone").check()
    tell(page, "Yes!")
    expect(page.locator("#hush")).to_be_visible()
    page.locator("#listen").click()
    expect(page.locator("#hush")).to_be_hidden()
    page.evaluate(
        "ear.onresult({results: [Object.assign([{transcript: 'I like tea'}], {isFinal: true})]})"
    )
    expect(page.locator(".yours .bubble").last).to_have_text("I like tea")


@pytest.mark.parametrize(
    ("sentence", "shown"),
    [
        ("Hello, $name! How are you?", "Hello! How are you?"),
        ("Hello $name, how are you?", "Hello, how are you?"),
        ("How are you, $name?", "How are you?"),
        ("$name, do you like tea?", "Do you like tea?"),
        ("Well, $name, let us see.", "Well, let us see."),
        ("Ah! $name, è vero?", "Ah! È vero?"),
        ("$nameさん、お元気ですか。", "お元気ですか。"),
        ("そうですね、$nameさん。", "そうですね。"),
        ("ところで、$nameさんは紅茶がお好きですか。", "ところで、紅茶がお好きですか。"),
        ("It costs $5.", "It costs $5."),
    ],
)
def test_the_name_nobody_has_is_dropped_with_its_comma(
    page: Page, sentence: str, shown: str
) -> None:
    page.goto("/")
    tidy = "async (text) => (await import('/static/chat/sentences.js')).withoutName(text)"
    assert page.evaluate(tidy, sentence) == shown


def test_every_language_has_every_word(page: Page) -> None:
    page.goto("/")
    words = page.evaluate("async () => (await import('/static/chat/words.js')).WORDS")
    assert words["it"].keys() == words["en"].keys() == words["ja"].keys()
    used = page.evaluate(
        "[...document.querySelectorAll('[data-words], [data-label]')]"
        ".flatMap((node) => [node.dataset.words, node.dataset.label].filter(Boolean))"
    )
    assert set(used) <= words["en"].keys()


def test_without_javascript_the_page_says_what_it_needs(page: Page) -> None:
    text = page.request.get("/").text()
    message = text[text.index("<noscript>") : text.index("</noscript>")]
    for language in ("en", "it", "ja"):
        assert f'lang="{language}"' in message
    assert "please allow JavaScript" in message


def test_the_footer_says_what_is_kept_and_leads_on(page: Page) -> None:
    page.goto("/")
    footer = page.get_by_role("contentinfo")
    expect(footer).to_contain_text("Nothing you say is stored on the server")
    assert footer.get_by_role("link").evaluate_all(
        "links => links.map((link) => link.pathname)"
    ) == ["/api/docs/", "/admin/"]
