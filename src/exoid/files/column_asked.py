"""How the library asks to name a column, for those who say it otherwise: options, keys."""

import re

COLUMN = re.compile(r'\bcolumns=\{"(\w+)": ("[^"]*"|NAME)\}')
