//! Reads TOML or JSON into checked values, collecting every fault.
