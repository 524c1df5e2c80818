"""`python -m exoid`: the command line where its script is not on the path."""

from exoid.cli import main

if __name__ == "__main__":
    main()
