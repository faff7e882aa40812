"""Programs side by side: two controls, two versions, one program for another control."""
