"""The YAML files of content/."""
