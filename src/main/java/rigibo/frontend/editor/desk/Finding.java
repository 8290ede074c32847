package rigibo.frontend.editor.desk;

import rigibo.frontend.document.Problem;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A problem as the editor shows it.
 *
 * @param problem as the loader or the check worded it
 */
public record Finding(Problem problem) {

    private static final Pattern ITEM =
            Pattern.compile("(/bodies/\\d+|/ball|/moreBalls/\\d+|/platform|/joints/\\d+)(/.*)?");
    private static final Pattern CODE = Pattern.compile("(E\\d{3}) .*", Pattern.DOTALL);

    /** JSON pointer of the item concerned; empty if it is the level as a whole. */
    public String item() {
        Matcher matcher = ITEM.matcher(problem.pointer());
        return matcher.matches() ? matcher.group(1) : "";
    }

    /** Code of the problem, such as E101, or {@code schema} for those that the schema found. */
    public String code() {
        Matcher matcher = CODE.matcher(problem.message());
        return matcher.matches() ? matcher.group(1) : "schema";
    }
}
