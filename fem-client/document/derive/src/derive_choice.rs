//! `derive(Choice)`.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Data, DeriveInput, Error, Fields, Ident, Variant};

use crate::attributes::given_name;
use crate::described::{described, kebab};

pub fn derive(input: DeriveInput) -> syn::Result<TokenStream> {
    let Data::Enum(data) = &input.data else {
        return Err(Error::new_spanned(&input, "only an enum is a choice"));
    };
    let choices: Vec<(&Ident, String, String)> =
        data.variants.iter().map(of).collect::<syn::Result<_>>()?;
    let this = &input.ident;
    let values: Vec<&Ident> = choices.iter().map(|choice| choice.0).collect();
    let names: Vec<&String> = choices.iter().map(|choice| &choice.1).collect();
    let docs: Vec<&String> = choices.iter().map(|choice| &choice.2).collect();
    let (doc, count) = (described(&input.attrs), values.len());
    Ok(quote! {
        impl #this {
            /// Values, in their order in documents.
            pub const ALL: [Self; #count] = [#(Self::#values),*];

            /// The name in documents.
            pub const fn as_str(self) -> &'static str {
                match self {
                    #(Self::#values => #names,)*
                }
            }

            /// The one of this name.
            pub fn named(name: &str) -> Option<Self> {
                Self::ALL.into_iter().find(|choice| choice.as_str() == name)
            }
        }

        impl ::document::typed::named_choice::Choice for #this {
            const CHOICES: &'static [(&'static str, Self)] = &[#((#names, Self::#values)),*];
            const MEANINGS: &'static [&'static str] = &[#(#docs),*];
        }

        impl ::document::typed::field_value::Field for #this {
            type Within = ();

            fn read(
                value: &::document::Value,
                at: &str,
                (): &(),
                faults: &mut Vec<::document::fault::Fault>,
            ) -> Option<Self> {
                ::document::fields::choice(value, at, <Self as ::document::typed::named_choice::Choice>::CHOICES, faults)
            }

            fn write(&self) -> Option<::document::Value> {
                Some(self.as_str().into())
            }

            fn schema((): &(), _: &mut ::document::json_schema::Schemas) -> ::document::Value {
                ::document::typed::named_choice::choice_schema::<Self>()
            }
        }

        impl ::document::serde::Serialize for #this {
            fn serialize<S: ::document::serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.serialize_str(self.as_str())
            }
        }

        impl<'de> ::document::serde::Deserialize<'de> for #this {
            fn deserialize<D: ::document::serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                ::document::typed::named_choice::deserialize_choice(deserializer)
            }
        }

        impl ::document::utoipa::PartialSchema for #this {
            fn schema() -> ::document::utoipa::openapi::RefOr<::document::utoipa::openapi::Schema> {
                ::document::typed::named_choice::open_api_choice::<Self>(#doc)
            }
        }

        impl ::document::utoipa::ToSchema for #this {}
    })
}

/// A variant, its name in documents, and what it means.
fn of(variant: &Variant) -> syn::Result<(&Ident, String, String)> {
    if !matches!(variant.fields, Fields::Unit) {
        return Err(Error::new_spanned(variant, "a choice has no fields"));
    }
    let given = given_name(&variant.attrs)?;
    let name = given.unwrap_or_else(|| kebab(&variant.ident.to_string()));
    Ok((&variant.ident, name, described(&variant.attrs)))
}
