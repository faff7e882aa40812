"""Programs beside each other: two controls, two versions, one program for another control."""
