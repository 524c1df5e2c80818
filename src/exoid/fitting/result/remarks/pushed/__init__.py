"""What a torque that no model has would make of a fit."""
