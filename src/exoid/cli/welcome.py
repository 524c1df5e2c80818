"""exoid without a command: what to do first."""

WELCOME = """\
exoid finds the mechanical parameters of a lower leg from recordings of a passive exoskeleton.

  exoid fit                  see it work: fits the example that comes with exoid
  exoid example              copies that example here, with a sidecar to start yours from
  exoid fit drop.csv         your own recording; drop.toml beside it says whose leg it is
  exoid drops drop.csv       what clinicians read off a drop
  exoid diagnose drop.csv    which physics the model lacks, proved
  exoid report drop.csv      all of it on one page, to look at and print
  exoid plan drop.csv        what to record next
  exoid export leg.nc --as mjcf
                             a saved fit for MuJoCo, URDF, OpenSim, C or Python

'exoid --help' lists all commands, 'exoid COMMAND --help' shows one with examples, and
'exoid --install-completion' lets the Tab key complete them."""
