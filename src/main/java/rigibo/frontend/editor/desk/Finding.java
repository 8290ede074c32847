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

    /** JSON pointer of the item concerned; empty if it is the level as a whole. */
    public String item() {
        Matcher matcher = ITEM.matcher(problem.pointer());
        return matcher.matches() ? matcher.group(1) : "";
    }
}
