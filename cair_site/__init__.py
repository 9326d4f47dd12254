"""The site: settings, addresses, the Hub, the clients that exist."""
