//! `derive(Variants)`.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Data, DeriveInput, Error, Fields, Ident, LitStr};

use crate::attributes::given_name;
use crate::derive_table::TableField;
use crate::described::{described, kebab};

struct Variant {
    ident: Ident,
    name: String,
    doc: String,
    fields: Vec<TableField>,
}

pub fn derive(input: DeriveInput) -> syn::Result<TokenStream> {
    let Data::Enum(data) = &input.data else {
        return Err(Error::new_spanned(&input, "only an enum has variants"));
    };
    let this = &input.ident;
    let VariantsAttributes { tag, usual, table } = VariantsAttributes::of(&input)?;
    let variants: Vec<Variant> = data.variants.iter().map(of).collect::<syn::Result<_>>()?;
    let idents: Vec<&Ident> = variants.iter().map(|variant| &variant.ident).collect();
    let names: Vec<&String> = variants.iter().map(|variant| &variant.name).collect();
    let own = variants.iter().map(|variant| {
        let names = variant.fields.iter().map(|field| &field.name);
        quote!(&[#(#names),*])
    });
    let defaults = variants.iter().map(|variant| {
        let ident = &variant.ident;
        let fields = variant.fields.iter().map(|field| {
            let (ident, default) = (&field.ident, field.default());
            quote!(#ident: #default)
        });
        quote!(Self::#ident { #(#fields),* })
    });
    let defaults: Vec<TokenStream> = defaults.collect();
    let usual = usual.and_then(|usual| variants.iter().position(|it| it.ident == usual));
    let usual = &defaults[usual.unwrap_or(0)];
    let reads = variants.iter().map(read);
    let writes = variants.iter().map(|variant| {
        let ident = &variant.ident;
        let places: Vec<&Ident> = variant.fields.iter().map(|field| &field.ident).collect();
        let writes = variant.fields.iter().map(|field| {
            let ident = &field.ident;
            field.write(&quote!(#ident))
        });
        quote!(Self::#ident { #(#places),* } => { #(#writes)* })
    });
    let describes = variants.iter().map(|variant| {
        let (name, doc) = (&variant.name, &variant.doc);
        let describes = variant.fields.iter().map(TableField::describe);
        quote! {{
            let mut own = ::document::json_schema::Properties::default();
            {
                let properties = &mut own;
                #(#describes)*
            }
            alternatives.push((#name, #doc, own));
        }}
    });
    let table = table.then(|| of_table(this, &described(&input.attrs)));
    Ok(quote! {
        #table

        impl #this {
            /// Returns each kind once, with its defaults.
            pub fn all() -> Vec<Self> {
                <Self as ::document::typed::kinds::Variants>::all()
            }

            /// The kind of this name in documents, with its defaults.
            pub fn of_name(name: &str) -> Option<Self> {
                <Self as ::document::typed::kinds::Variants>::of_name(name)
            }

            /// The kind's name in documents.
            pub fn name(&self) -> &'static str {
                <Self as ::document::typed::kinds::Variants>::name(self)
            }
        }

        impl ::document::typed::table_fields::Group for #this {
            fn names(value: &::document::Value, usual: &Self) -> Vec<&'static str> {
                ::document::typed::kinds::variant_names(value, usual)
            }

            fn read_fields(
                fields: &::document::fields::Fields<'_>,
                usual: Self,
                faults: &mut Vec<::document::fault::Fault>,
            ) -> Option<Self> {
                ::document::typed::kinds::read_variant(fields, usual, faults)
            }

            fn write_fields(&self, table: &mut ::document::Map) {
                ::document::typed::kinds::write_variant(self, table);
            }

            fn describe(
                usual: &Self,
                properties: &mut ::document::json_schema::Properties,
                schemas: &mut ::document::json_schema::Schemas,
            ) {
                ::document::typed::kinds::describe_variants(usual, properties, schemas);
            }
        }

        impl ::document::typed::kinds::Variants for #this {
            const TAG: &'static str = #tag;

            fn all() -> Vec<Self> {
                vec![#(#defaults),*]
            }

            fn usual() -> Self {
                #usual
            }

            fn name(&self) -> &'static str {
                match self {
                    #(Self::#idents { .. } => #names,)*
                }
            }

            fn own_names(&self) -> &'static [&'static str] {
                match self {
                    #(Self::#idents { .. } => #own,)*
                }
            }

            fn read_own(
                self,
                fields: &::document::fields::Fields<'_>,
                faults: &mut Vec<::document::fault::Fault>,
            ) -> Option<Self> {
                match self {
                    #(#reads)*
                }
            }

            fn write_own(&self, table: &mut ::document::Map) {
                match self {
                    #(#writes)*
                }
            }

            fn describe(
                schemas: &mut ::document::json_schema::Schemas,
            ) -> Vec<(&'static str, &'static str, ::document::json_schema::Properties)> {
                let mut alternatives = Vec::new();
                #(#describes)*
                alternatives
            }
        }
    })
}

/// An arm that reads a variant's fields, whose values before are the defaults.
fn read(variant: &Variant) -> TokenStream {
    let ident = &variant.ident;
    let places: Vec<&Ident> = variant.fields.iter().map(|field| &field.ident).collect();
    let reads = variant.fields.iter().map(|field| {
        let (ident, read) = (
            &field.ident,
            field.read(&{
                let ident = &field.ident;
                quote!(#ident)
            }),
        );
        quote!(let #ident = #read;)
    });
    quote! {
        Self::#ident { #(#places),* } => {
            #(#reads)*
            Some(Self::#ident { #(#places: #places?),* })
        }
    }
}

/// Content of `#[variants(...)]`.
#[derive(Default)]
struct VariantsAttributes {
    tag: String,
    /// The kind of a table that names none; the first where it isn't said.
    usual: Option<Ident>,
    /// Whether the fields are a table by themselves.
    table: bool,
}

impl VariantsAttributes {
    fn of(input: &DeriveInput) -> syn::Result<Self> {
        let mut read = Self::default();
        for attribute in input
            .attrs
            .iter()
            .filter(|it| it.path().is_ident("variants"))
        {
            attribute.parse_nested_meta(|meta| {
                let name = meta.path.require_ident()?.to_string();
                match name.as_str() {
                    "tag" => read.tag = meta.value()?.parse::<LitStr>()?.value(),
                    "usual" => read.usual = Some(meta.value()?.parse()?),
                    "table" => read.table = true,
                    _ => return Err(meta.error("no such attribute of variants")),
                }
                Ok(())
            })?;
        }
        match read.tag.is_empty() {
            true => Err(Error::new_spanned(
                &input.ident,
                "needs #[variants(tag = \"...\")]",
            )),
            false => Ok(read),
        }
    }
}

/// A table that has nothing but the fields of its kind.
fn of_table(this: &Ident, doc: &str) -> TokenStream {
    let name = this.to_string();
    quote! {
        impl ::document::typed::field_value::Field for #this {
            type Within = ();

            fn read(
                value: &::document::Value,
                at: &str,
                (): &(),
                faults: &mut Vec<::document::fault::Fault>,
            ) -> Option<Self> {
                ::document::typed::kinds::read_kind(value, at, faults)
            }

            fn write(&self) -> Option<::document::Value> {
                Some(::document::typed::kinds::kind_value(self))
            }

            fn schema((): &(), schemas: &mut ::document::json_schema::Schemas) -> ::document::Value {
                ::document::typed::kinds::kind_schema::<Self>(#name, #doc, schemas)
            }
        }
    }
}

fn of(variant: &syn::Variant) -> syn::Result<Variant> {
    let given = given_name(&variant.attrs)?;
    Ok(Variant {
        ident: variant.ident.clone(),
        name: given.unwrap_or_else(|| kebab(&variant.ident.to_string())),
        doc: described(&variant.attrs),
        fields: match &variant.fields {
            Fields::Unit => Vec::new(),
            fields => TableField::all(fields)?,
        },
    })
}
