"""The live editor: a page in the browser, the server behind it, and static folders that need none."""
