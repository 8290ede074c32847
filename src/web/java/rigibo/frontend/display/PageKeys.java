package rigibo.frontend.display;

import static org.lwjgl.glfw.GLFW.*;

import org.teavm.jso.dom.events.KeyboardEvent;

import java.util.HashMap;
import java.util.Map;

/** The keys of a browser, by GLFW's numbers. */
final class PageKeys {

    private static final String LETTER = "Key";
    private static final String DIGIT = "Digit";
    private static final Map<String, Integer> CODES = codes();

    private PageKeys() {}

    /**
     * The number of a key; of a letter by its imprint.
     *
     * @param place of the key on the keyboard
     * @param meaning the text that it types
     */
    static int code(String place, String meaning) {
        if (place.startsWith(LETTER)) {
            boolean isLetter = meaning.length() == 1 && Character.isLetter(meaning.charAt(0));
            char letter = isLetter ? meaning.charAt(0) : place.charAt(LETTER.length());
            return GLFW_KEY_A + Character.toUpperCase(letter) - 'A';
        }
        if (place.startsWith(DIGIT)) {
            return GLFW_KEY_0 + place.charAt(DIGIT.length()) - '0';
        }
        return CODES.getOrDefault(place, GLFW_KEY_UNKNOWN);
    }

    /**
     * Whether only the game should handle a key: otherwise browsers scroll, search or leave the
     * page.
     */
    static boolean isOurs(int code, KeyboardEvent key) {
        boolean isCommand = key.isCtrlKey() || key.isMetaKey() || key.isAltKey();
        return code != GLFW_KEY_UNKNOWN && !isCommand;
    }

    private static Map<String, Integer> codes() {
        Map<String, Integer> codes = new HashMap<>();
        codes.put("Escape", GLFW_KEY_ESCAPE);
        codes.put("Enter", GLFW_KEY_ENTER);
        codes.put("NumpadEnter", GLFW_KEY_KP_ENTER);
        codes.put("Space", GLFW_KEY_SPACE);
        codes.put("Tab", GLFW_KEY_TAB);
        codes.put("Backspace", GLFW_KEY_BACKSPACE);
        codes.put("Delete", GLFW_KEY_DELETE);
        codes.put("Period", GLFW_KEY_PERIOD);
        codes.put("BracketLeft", GLFW_KEY_LEFT_BRACKET);
        codes.put("BracketRight", GLFW_KEY_RIGHT_BRACKET);
        codes.put("Home", GLFW_KEY_HOME);
        codes.put("ArrowUp", GLFW_KEY_UP);
        codes.put("ArrowDown", GLFW_KEY_DOWN);
        codes.put("ArrowLeft", GLFW_KEY_LEFT);
        codes.put("ArrowRight", GLFW_KEY_RIGHT);
        codes.put("F1", GLFW_KEY_F1);
        codes.put("F11", GLFW_KEY_F11);
        codes.put("ShiftLeft", GLFW_KEY_LEFT_SHIFT);
        codes.put("ShiftRight", GLFW_KEY_RIGHT_SHIFT);
        codes.put("ControlLeft", GLFW_KEY_LEFT_CONTROL);
        codes.put("ControlRight", GLFW_KEY_RIGHT_CONTROL);
        codes.put("MetaLeft", GLFW_KEY_LEFT_SUPER);
        codes.put("MetaRight", GLFW_KEY_RIGHT_SUPER);
        return codes;
    }
}
