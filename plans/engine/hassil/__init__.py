"""Templates of hassil (Home Assistant's matcher) turned into the triggers of this library."""
