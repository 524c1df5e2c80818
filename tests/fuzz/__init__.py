"""Damages files of every format that exoid reads, and judges what it then says of them."""
