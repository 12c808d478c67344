//! `derive(Table)`.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{
    Data, DeriveInput, Error, Expr, ExprCall, Fields, Ident, LitStr, Path, Token, Type, bracketed,
    parse_quote,
};

use crate::attributes::FieldAttributes;
use crate::described::described;

/// A field of a struct or of a variant.
pub(crate) struct TableField {
    pub ident: Ident,
    pub name: String,
    pub ty: Type,
    pub doc: String,
    pub attributes: FieldAttributes,
}

impl TableField {
    pub fn all(fields: &Fields) -> syn::Result<Vec<Self>> {
        let Fields::Named(named) = fields else {
            return Err(Error::new_spanned(fields, "a table has named fields"));
        };
        let of = |field: &syn::Field| {
            let ident = field.ident.clone().unwrap_or(format_ident!("_"));
            Ok(Self {
                name: ident.to_string(),
                ident,
                ty: field.ty.clone(),
                doc: described(&field.attrs),
                attributes: FieldAttributes::of(&field.attrs)?,
            })
        };
        named.named.iter().map(of).collect()
    }

    pub fn default(&self) -> TokenStream {
        match &self.attributes.default {
            Some(default) => quote!(#default),
            None => quote!(Default::default()),
        }
    }

    fn within(&self) -> Expr {
        let within = self.attributes.within.clone();
        within.unwrap_or_else(|| parse_quote!(()))
    }

    /// Returns what reads, writes and describes a group of fields; None of a single field.
    fn group(&self) -> Option<TokenStream> {
        let ty = &self.ty;
        self.attributes.group.as_ref().map(|module| match module {
            Some(module) => quote!(#module),
            None => quote!(<#ty as ::document::typed::table_fields::Group>),
        })
    }

    /// An expression for an `Option` of the field, which adds its faults.
    pub fn read(&self, default: &TokenStream) -> TokenStream {
        let (name, ty, within) = (&self.name, &self.ty, self.within());
        if let Some(group) = self.group() {
            return quote!(#group::read_fields(fields, #default, faults));
        }
        let read = match &self.attributes.with {
            Some(module) => quote!(|value, at, faults| #module::read(value, at, faults)),
            None => {
                quote!(|value, at, faults| <#ty as ::document::typed::field_value::Field>::read(value, at, &#within, faults))
            }
        };
        if let Some(what) = &self.attributes.required {
            return quote!(::document::typed::table_fields::required(fields, #name, #what, faults, #read));
        }
        let nullable = self.attributes.nullable;
        quote!(::document::typed::table_fields::optional(fields, #name, #nullable, || #default, faults, #read))
    }

    /// Puts the field into `table`; `place` is an expression for a reference to it.
    pub fn write(&self, place: &TokenStream) -> TokenStream {
        let (name, ty) = (&self.name, &self.ty);
        if let Some(group) = self.group() {
            return quote!(#group::write_fields(#place, table););
        }
        let written = match &self.attributes.with {
            Some(module) => quote!(#module::write(#place)),
            None => quote!(<#ty as ::document::typed::field_value::Field>::write(#place)),
        };
        let put = quote! {
            if let Some(value) = #written {
                table.insert(#name.to_owned(), value);
            }
        };
        if !self.attributes.omitted {
            return put;
        }
        let default = self.default();
        quote! {
            let usual: #ty = #default;
            if *#place != usual {
                #put
            }
        }
    }

    /// Adds the field to `properties`.
    pub fn describe(&self) -> TokenStream {
        let (name, ty, doc, within) = (&self.name, &self.ty, &self.doc, self.within());
        if let Some(group) = self.group() {
            let default = self.default();
            return quote!(#group::describe(&#default, properties, schemas););
        }
        let (schema, written) = match &self.attributes.with {
            Some(module) => (
                quote!(#module::schema(schemas)),
                quote!(#module::write(&usual)),
            ),
            None => (
                quote!(<#ty as ::document::typed::field_value::Field>::schema(&#within, schemas)),
                quote!(<#ty as ::document::typed::field_value::Field>::write(&usual)),
            ),
        };
        if self.attributes.required.is_some() {
            return quote!(properties.add_required(#name, #doc, #schema););
        }
        let (default, nullable) = (self.default(), self.attributes.nullable);
        quote! {
            let usual: #ty = #default;
            let default = #written;
            let schema = #schema;
            properties.add(#name, #doc, schema, default, #nullable);
        }
    }
}

/// Content of `#[table(...)]`.
#[derive(Default)]
struct TableAttributes {
    name: Option<LitStr>,
    before: Option<Path>,
    rules: Vec<Expr>,
    then: Option<Path>,
    told: Option<Vec<Told>>,
}

impl TableAttributes {
    fn of(input: &DeriveInput) -> syn::Result<Self> {
        let mut read = Self::default();
        for attribute in input.attrs.iter().filter(|it| it.path().is_ident("table")) {
            attribute.parse_nested_meta(|meta| {
                let name = meta.path.require_ident()?.to_string();
                match name.as_str() {
                    "name" => read.name = Some(meta.value()?.parse()?),
                    "before" => read.before = Some(meta.value()?.parse()?),
                    "rule" => read.rules.push(meta.value()?.parse()?),
                    "then" => read.then = Some(meta.value()?.parse()?),
                    "told" => read.told = Some(names(meta.value()?)?),
                    _ => return Err(meta.error("no such attribute of a table")),
                }
                Ok(())
            })?;
        }
        Ok(read)
    }
}

/// A name that is told: of a field, with all names of a group, or as it stands in quotes.
enum Told {
    Field(Ident),
    Name(LitStr),
}

impl Parse for Told {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        match input.peek(LitStr) {
            true => input.parse().map(Self::Name),
            false => input.parse().map(Self::Field),
        }
    }
}

fn names(list: ParseStream<'_>) -> syn::Result<Vec<Told>> {
    let inside;
    bracketed!(inside in list);
    let names = Punctuated::<Told, Token![,]>::parse_terminated(&inside)?;
    Ok(names.into_iter().collect())
}

/// A rule between some fields, which is asked whenever they are read, or of the whole table.
fn rule(rule: &Expr) -> syn::Result<(TokenStream, bool)> {
    match rule {
        Expr::Path(function) => Ok((quote!(#function(&read, fields, faults)?;), true)),
        Expr::Call(ExprCall { func, args, .. }) => {
            let asked: Vec<&Expr> = args.iter().collect();
            Ok((
                quote! {
                    if let (#(Some(#asked),)*) = (#(&#asked,)*) {
                        #func(#(#asked,)* fields, faults);
                    }
                },
                false,
            ))
        }
        other => Err(Error::new_spanned(other, "a function, or a call of one")),
    }
}

pub fn derive(input: DeriveInput) -> syn::Result<TokenStream> {
    let Data::Struct(data) = &input.data else {
        return Err(Error::new_spanned(&input, "only a struct is a table"));
    };
    let fields = TableField::all(&data.fields)?;
    let TableAttributes {
        name,
        before,
        rules,
        then,
        told,
    } = TableAttributes::of(&input)?;
    let told = told.unwrap_or_else(|| {
        let all = fields.iter().map(|field| Told::Field(field.ident.clone()));
        all.collect()
    });
    let rules: Vec<(TokenStream, bool)> = rules.iter().map(rule).collect::<syn::Result<_>>()?;
    let of_all = rules.iter().filter(|(_, of_all)| *of_all).map(|it| &it.0);
    let of_some = rules.iter().filter(|(_, of_all)| !*of_all).map(|it| &it.0);
    let (this, doc) = (&input.ident, described(&input.attrs));
    let name = name.map_or_else(|| this.to_string(), |name| name.value());
    let idents: Vec<&Ident> = fields.iter().map(|field| &field.ident).collect();
    let defaults: Vec<TokenStream> = fields.iter().map(TableField::default).collect();
    let names = told.iter().map(|told| {
        let (name, field) = match told {
            Told::Name(name) => (name.value(), None),
            Told::Field(ident) => {
                let field = fields.iter().find(|field| field.ident == *ident);
                (ident.to_string(), field)
            }
        };
        match field.and_then(|field| Some((field.group()?, field.default()))) {
            Some((group, usual)) => quote!(names.extend(#group::names(value, &#usual));),
            None => quote!(names.push(#name);),
        }
    });
    let reads = fields.iter().map(|field| {
        let (ident, read) = (&field.ident, field.read(&field.default()));
        quote!(let #ident = #read;)
    });
    let writes = fields.iter().map(|field| {
        let ident = &field.ident;
        field.write(&quote!(&self.#ident))
    });
    let describes = fields.iter().map(TableField::describe);
    let then = then.map(|then| quote!(let read = #then(read, fields);));
    let before = before.map(|before| quote!(#before(value, at, faults)?;));
    let default = fields
        .iter()
        .all(|field| field.attributes.required.is_none())
        .then(|| {
            quote! {
                impl Default for #this {
                    fn default() -> Self {
                        Self { #(#idents: #defaults),* }
                    }
                }
            }
        });
    Ok(quote! {
        #default

        impl ::document::typed::table_fields::Table for #this {
            const NAME: &'static str = #name;
            const DOC: &'static str = #doc;

            fn names(value: &::document::Value) -> Vec<&'static str> {
                let mut names = Vec::new();
                #(#names)*
                names
            }

            fn read_fields(
                fields: &::document::fields::Fields<'_>,
                faults: &mut Vec<::document::fault::Fault>,
            ) -> Option<Self> {
                #(#reads)*
                #(#of_some)*
                let read = Self { #(#idents: #idents?),* };
                #(#of_all)*
                #then
                Some(read)
            }

            fn write_fields(&self, table: &mut ::document::Map) {
                #(#writes)*
            }

            fn describe(
                properties: &mut ::document::json_schema::Properties,
                schemas: &mut ::document::json_schema::Schemas,
            ) {
                #(#describes)*
            }
        }

        impl ::document::typed::field_value::Field for #this {
            type Within = ();

            fn read(
                value: &::document::Value,
                at: &str,
                (): &(),
                faults: &mut Vec<::document::fault::Fault>,
            ) -> Option<Self> {
                #before
                ::document::typed::table_fields::read_table(value, at, faults)
            }

            fn write(&self) -> Option<::document::Value> {
                Some(::document::typed::table_fields::table_value(self))
            }

            fn schema((): &(), schemas: &mut ::document::json_schema::Schemas) -> ::document::Value {
                ::document::typed::table_fields::table_schema::<Self>(schemas)
            }
        }
    })
}
