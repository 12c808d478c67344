//! Contract of the laws of a layer.

/// In-plane components 11, 22 and 12; of strains the third is doubled, so that S . dE is the work.
pub type InPlane = [f64; 3];

/// An elastic layer: energy zero and no tension at E = 0.
pub trait SurfaceLaw: std::fmt::Debug + Send + Sync {
    /// Stored energy per reference area, N/mm.
    fn energy(&self, strain: &InPlane) -> f64;

    /// Tensions and their derivatives by the strain, N/mm.
    fn tensions(&self, strain: &InPlane) -> (InPlane, [InPlane; 3]);

    /// Largest stiffness in the reference state, N/mm.
    fn stiffness(&self) -> f64;
}
