package rigibo.frontend.scene;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * A scene and the choices made in it, as the text of an address: {@code
 * pendulum?accuracy=fine&length=1.2}. Anybody may have written the text, so only short words and
 * numbers are taken from it.
 *
 * @param scene its name; empty for the menu
 * @param choices the choices, by name
 */
public record Link(String scene, Map<String, String> choices) {

    /** Leads to the menu. */
    public static final Link MENU = Link.to("");

    /** Longer texts are no links, in characters. */
    static final int LONGEST = 400;

    private static final String GHOST = "ghost";
    private static final String ON = "on";

    private static final Pattern NAME = Pattern.compile("[a-z0-9-]{1,60}");

    private static final Pattern VALUE =
            Pattern.compile("[a-z]{1,20}|-?[0-9]{1,6}(\\.[0-9]{1,6})?");

    public Link {
        choices = new LinkedHashMap<>(choices);
    }

    /** A link to a scene as it begins. */
    public static Link to(String scene) {
        return new Link(scene, Map.of());
    }

    /**
     * Reads a text. A part that is no name, word or number becomes a choice that no scene knows.
     */
    public static Link of(String text) {
        int end = text.indexOf('?');
        String scene = end < 0 ? text : text.substring(0, end);
        if (text.length() > LONGEST || !NAME.matcher(scene).matches()) {
            return MENU;
        }
        Map<String, String> read = new LinkedHashMap<>();
        if (end >= 0) {
            for (String choice : text.substring(end + 1).split("&", -1)) {
                int is = choice.indexOf('=');
                String name = choice.substring(0, Math.max(0, is));
                String value = choice.substring(is + 1);
                boolean isSound = NAME.matcher(name).matches() && VALUE.matcher(value).matches();
                read.put(isSound ? name : "", isSound ? value : "");
            }
        }
        return new Link(scene, read);
    }

    /** Returns this link with the ghost shown. */
    public Link withGhost() {
        return with(GHOST, ON);
    }

    /** Whether the ghost is to be shown. */
    public boolean hasGhost() {
        return ON.equals(choices.get(GHOST));
    }

    /** Returns this link with one more choice. */
    public Link with(String name, String value) {
        Map<String, String> more = new LinkedHashMap<>(choices);
        more.put(name, value);
        return new Link(scene, more);
    }

    /** Its text. */
    public String text() {
        return choices.isEmpty()
                ? scene
                : choices.entrySet().stream()
                        .map(choice -> choice.getKey() + "=" + choice.getValue())
                        .collect(Collectors.joining("&", scene + "?", ""));
    }
}
