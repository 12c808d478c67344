//! The words in which signals are told: enums that stand in documents as their names.

use serde::{Deserialize, Serialize};

/// An enum with a name for each of its values.
macro_rules! words {
    ($(#[doc = $doc:literal])+ $word:ident { $($(#[$of_value:meta])* $value:ident = $name:literal,)+ }) => {
        $(#[doc = $doc])+
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
        pub enum $word {
            $($(#[$of_value])* #[serde(rename = $name)] $value,)+
        }

        // What would be derived doesn't see names that come through a macro.
        #[cfg(feature = "openapi")]
        impl utoipa::PartialSchema for $word {
            fn schema() -> utoipa::openapi::RefOr<utoipa::openapi::Schema> {
                utoipa::openapi::ObjectBuilder::new()
                    .schema_type(utoipa::openapi::Type::String)
                    .enum_values(Some(Self::ALL.map(Self::as_str)))
                    .description(Some(concat!($($doc),+).trim()))
                    .into()
            }
        }

        #[cfg(feature = "openapi")]
        impl utoipa::ToSchema for $word {}

        impl $word {
            /// All of them, in their order in documents.
            pub const ALL: [Self; [$($name),+].len()] = [$(Self::$value),+];

            /// The name in documents.
            pub const fn as_str(self) -> &'static str {
                match self {
                    $(Self::$value => $name,)+
                }
            }

            /// The one of this name.
            pub fn named(name: &str) -> Option<Self> {
                Self::ALL.into_iter().find(|word| word.as_str() == name)
            }
        }
    };
}

words! {
    /// How a film is modelled.
    FilmModel {
        /// It follows the wall and resists nothing.
        Bare = "bare",
        /// Bare, its strains made tensions by a matrix that two coupled solves give.
        Transfer = "transfer",
        /// Glued to the wall, with its stiffness.
        Coupled = "coupled",
    }
}

words! {
    /// What changes along a curve.
    SignalAxis {
        /// The load, N.
        Load = "load",
        /// The internal pressure, MPa.
        Pressure = "pressure",
        /// The wheel angle from the film to the contact, degrees.
        Contact = "contact",
    }
}

words! {
    /// Which way a curve goes.
    Trend {
        /// Every value is larger than the one before.
        Up = "up",
        /// Every value is smaller than the one before.
        Down = "down",
        /// Neither.
        No = "no",
    }
}

words! {
    /// What is claimed of films' voltages.
    Claim {
        /// Over the loads.
        RisesWithLoad = "voltage rises with load",
        /// Over the pressures.
        FallsWithPressure = "voltage falls with pressure",
        /// Over the contact angles.
        Linear = "linear over the contact angle",
    }
}

words! {
    /// Whether a claim holds.
    Holds {
        /// It does, and no error could change that.
        Yes = "yes",
        /// It doesn't, and no error could change that.
        No = "no",
        /// The errors, or what wasn't solved, leave it open.
        Uncertain = "uncertain",
    }
}
