package rigibo.docs.site;

import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Marks comments, texts, words and numbers of Java in HTML that was escaped. */
final class JavaColors {

    private static final String WORDS =
            "abstract|assert|boolean|break|byte|case|catch|char|class|continue|default|do|double"
                    + "|else|enum|extends|final|finally|float|for|if|implements|import|instanceof"
                    + "|int|interface|long|module|new|null|package|permits|private|protected|public"
                    + "|record|requires|return|sealed|short|static|super|switch|this|throw|throws"
                    + "|true|false|try|var|void|volatile|while";

    /** A group for each kind. */
    private static final Pattern PARTS =
            Pattern.compile(
                    "(/\\*.*?\\*/|//[^\\n]*)"
                            + "|(&quot;(?:\\\\.|(?!&quot;)[^\\n])*&quot;|'(?:\\\\.|[^'\\n])')"
                            + ("|\\b(" + WORDS + ")\\b")
                            + "|\\b(\\d[\\d_.]*(?:e-?\\d+)?)\\b",
                    Pattern.DOTALL);

    /** Class of each kind in the style sheet. */
    private static final List<String> KINDS = List.of("comment", "text", "word", "number");

    private JavaColors() {}

    static String of(String escaped) {
        return PARTS.matcher(escaped).replaceAll(JavaColors::marked);
    }

    private static String marked(MatchResult found) {
        int kind = 1;
        while (found.group(kind) == null) {
            kind++;
        }
        String part = Matcher.quoteReplacement(found.group());
        return "<span class=\"" + KINDS.get(kind - 1) + "\">" + part + "</span>";
    }
}
