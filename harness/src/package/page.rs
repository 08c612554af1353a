//! The documentation page of an FMU: its Markdown as one HTML file that needs nothing else.

use percent_encoding::{NON_ALPHANUMERIC, utf8_percent_encode};
use pulldown_cmark::{Event, Options, Parser, html};

/// Looks good on screens light and dark, and on paper.
const STYLE: &str = include_str!("page.css");

/// Turns the documentation into a page with the icon at its head. HTML in the Markdown is shown, not obeyed; the icon is
/// one that could be drawn, but is not obeyed either: as an image it runs no script and loads nothing.
pub fn page(title: &str, markdown: &str, icon: &str) -> String {
    let options = Options::ENABLE_TABLES | Options::ENABLE_STRIKETHROUGH | Options::ENABLE_FOOTNOTES;
    let events = Parser::new_ext(markdown, options).map(|event| match event {
        Event::Html(text) | Event::InlineHtml(text) => Event::Text(text),
        other => other,
    });
    let icon = utf8_percent_encode(icon, NON_ALPHANUMERIC);
    let mut body = format!("<img class=\"icon\" alt=\"\" src=\"data:image/svg+xml,{icon}\">\n");
    html::push_html(&mut body, events);
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n{body}</body>\n</html>\n",
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keeps_tables_and_unicode_and_needs_nothing_else() {
        let icon = r#"<svg xmlns="http://www.w3.org/2000/svg"><script>y</script></svg>"#;
        let page = page("Sample", "# ẇ = (g + F/m)⊥\n\n| a | b |\n|---|---|\n| 1 | <script>x</script> |\n", icon);
        assert!(page.contains("<h1>ẇ = (g + F/m)⊥</h1>"));
        assert!(page.contains("<td>1</td>"));
        assert!(!page.contains("<script>"));
        assert!(page.contains("src=\"data:image/svg") && page.matches("src=").count() == 1);
        assert!(!page.contains("http:"));
    }
}
