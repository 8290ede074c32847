package rigibo.docs.site;

/** Small pieces of HTML. */
final class Html {

    private Html() {}

    /** A text as it stands in HTML. */
    static String escaped(String text) {
        return text.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }

    /** A link to what already is HTML. */
    static String link(String address, String html) {
        return "<a href=\"" + escaped(address) + "\">" + html + "</a>";
    }

    /** A picture that is loaded when it comes into view. */
    static String picture(String address, String words) {
        return "<img loading=\"lazy\" src=\""
                + escaped(address)
                + "\" alt=\""
                + escaped(words)
                + "\">";
    }
}
