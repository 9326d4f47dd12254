"""The ways of matching, tried in this order; the first that finds something decides."""

from collections.abc import Callable

from languages.language import Language
from plans.engine.intents import Library
from plans.engine.matchers.matcher import Matcher
from plans.engine.matchers.patterns_compiler import compile_patterns
from plans.engine.problems import Problem

MATCHERS: tuple[Callable[[Library, Language, list[Problem]], Matcher], ...] = (compile_patterns,)
