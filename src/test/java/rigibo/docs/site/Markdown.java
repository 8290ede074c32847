package rigibo.docs.site;

import org.commonmark.Extension;
import org.commonmark.ext.gfm.tables.TablesExtension;
import org.commonmark.ext.heading.anchor.HeadingAnchorExtension;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.Code;
import org.commonmark.node.Heading;
import org.commonmark.node.Node;
import org.commonmark.node.Text;
import org.commonmark.parser.Parser;
import org.commonmark.renderer.html.HtmlRenderer;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Markdown as GitHub understands it: with tables, and an anchor for each heading. */
final class Markdown {

    private static final List<Extension> EXTENSIONS =
            List.of(TablesExtension.create(), HeadingAnchorExtension.create());

    private static final Parser PARSER = Parser.builder().extensions(EXTENSIONS).build();
    private static final HtmlRenderer RENDERER =
            HtmlRenderer.builder().extensions(EXTENSIONS).build();

    private static final Pattern JAVA =
            Pattern.compile("(?<=<code class=\"language-java\">).*?(?=</code>)", Pattern.DOTALL);

    private Markdown() {}

    static Node parse(String text) {
        return PARSER.parse(text);
    }

    static String html(Node document) {
        return JAVA.matcher(RENDERER.render(document))
                .replaceAll(code -> Matcher.quoteReplacement(JavaColors.of(code.group())));
    }

    /** The first heading, without its marks. */
    static String title(Node document) {
        StringBuilder title = new StringBuilder();
        heading(document, 1)
                .accept(
                        new AbstractVisitor() {
                            @Override
                            public void visit(Text text) {
                                title.append(text.getLiteral());
                            }

                            @Override
                            public void visit(Code code) {
                                title.append(code.getLiteral());
                            }
                        });
        return title.toString();
    }

    /** The first heading of a level. */
    static Heading heading(Node document, int level) {
        for (Node node = document.getFirstChild(); node != null; node = node.getNext()) {
            if (node instanceof Heading heading && heading.getLevel() == level) {
                return heading;
            }
        }
        throw new IllegalArgumentException("a page needs a heading of level " + level);
    }
}
