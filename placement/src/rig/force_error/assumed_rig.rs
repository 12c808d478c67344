//! What is assumed of a rig, as sentences: the paper states none of it.
