package rigibo.frontend.editor.desk;

import rigibo.frontend.scene.Key;

import java.util.function.Consumer;

/** A text while it is typed, and its destination. */
public final class Typing {

    private static final Consumer<String> NOWHERE = text -> {};

    private String field = "";
    private String text = "";
    private Consumer<String> done = NOWHERE;

    /** Begins with what a field holds; what was typed before it goes to its own. */
    public void begin(String name, String initial, Consumer<String> commit) {
        end();
        field = name;
        text = initial;
        done = commit;
    }

    public boolean isOn() {
        return !field.isEmpty();
    }

    /** Whether it is a field's text that is typed. */
    public boolean isIn(String name) {
        return isOn() && field.equals(name);
    }

    /** What a field shows: what is typed into it, else what it holds. */
    public String shown(String name, String held) {
        return isIn(name) ? text + "|" : held;
    }

    /** A character at the end. */
    public void typed(int codePoint) {
        if (isOn() && !Character.isISOControl(codePoint)) {
            text += Character.toString(codePoint);
        }
    }

    /** Enter and Tab are done, Backspace takes the last character back. */
    public void keyPressed(Key key) {
        if (key == Key.BACKSPACE && !text.isEmpty()) {
            text = text.substring(0, text.offsetByCodePoints(text.length(), -1));
        } else if (key == Key.ENTER || key == Key.TAB) {
            end();
        }
    }

    /** What was typed goes to its field. */
    public void end() {
        Consumer<String> commit = done;
        String typed = text;
        cancel();
        commit.accept(typed);
    }

    /** What was typed goes nowhere. */
    public void cancel() {
        field = "";
        text = "";
        done = NOWHERE;
    }
}
