package rigibo.docs.site;

/** A file of text as a block of code. */
final class Source {

    private Source() {}

    static String html(String name, String text) {
        String escaped = Html.escaped(text);
        String code = name.endsWith(".java") ? JavaColors.of(escaped) : escaped;
        return "<pre class=\"source\"><code>" + code + "</code></pre>\n";
    }
}
