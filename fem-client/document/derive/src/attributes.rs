//! Reads `#[field(...)]` and `#[choice(...)]`.

use syn::{Attribute, Expr, LitStr, Path, Token};

/// Content of a field's attribute.
#[derive(Default)]
pub(crate) struct FieldAttributes {
    pub default: Option<Expr>,
    pub within: Option<Expr>,
    pub required: Option<LitStr>,
    pub with: Option<Path>,
    pub nullable: bool,
    pub omitted: bool,
    /// A `Group`, or the module that stands for one.
    pub group: Option<Option<Path>>,
}

impl FieldAttributes {
    pub fn of(attributes: &[Attribute]) -> syn::Result<Self> {
        let mut read = Self::default();
        for attribute in attributes.iter().filter(|it| it.path().is_ident("field")) {
            attribute.parse_nested_meta(|meta| {
                let name = meta.path.require_ident()?.to_string();
                match name.as_str() {
                    "default" => read.default = Some(meta.value()?.parse()?),
                    "within" => read.within = Some(meta.value()?.parse()?),
                    "required" => read.required = Some(meta.value()?.parse()?),
                    "with" => read.with = Some(meta.value()?.parse()?),
                    "nullable" => read.nullable = true,
                    "omitted" => read.omitted = true,
                    "group" if meta.input.peek(Token![=]) => {
                        read.group = Some(Some(meta.value()?.parse()?));
                    }
                    "group" => read.group = Some(None),
                    _ => return Err(meta.error("no such attribute of a field")),
                }
                Ok(())
            })?;
        }
        Ok(read)
    }
}

/// The name that `#[choice("name")]` gives a variant.
pub(crate) fn given_name(attributes: &[Attribute]) -> syn::Result<Option<String>> {
    let given = attributes.iter().find(|it| it.path().is_ident("choice"));
    given
        .map(|attribute| attribute.parse_args::<LitStr>().map(|name| name.value()))
        .transpose()
}
