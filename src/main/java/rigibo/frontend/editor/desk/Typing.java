package rigibo.frontend.editor.desk;

import rigibo.frontend.scene.Key;

import java.util.function.Consumer;

/** The text being typed, and the field that it goes to. */
public final class Typing {

    private static final Consumer<String> NOWHERE = text -> {};

    private String field = "";
    private String text = "";
    private Consumer<String> done = NOWHERE;

    /** Begins with the content of a field; a text typed before goes to its own field. */
    public void begin(String name, String initial, Consumer<String> commit) {
        end();
        field = name;
        text = initial;
        done = commit;
    }

    public boolean isOn() {
        return !field.isEmpty();
    }

    /** Whether the text being typed belongs to a field. */
    public boolean isIn(String name) {
        return isOn() && field.equals(name);
    }

    /** The text that is being typed, with a cursor at its end. */
    public String text() {
        return text + "|";
    }

    /** The text that a field shows: what is being typed into it, otherwise its content. */
    public String shown(String name, String held) {
        return isIn(name) ? text() : held;
    }

    /** Appends a character. */
    public void typed(int codePoint) {
        if (isOn() && !Character.isISOControl(codePoint)) {
            text += Character.toString(codePoint);
        }
    }

    /** Handles a key: Enter and Tab end typing, Backspace removes the last character. */
    public void keyPressed(Key key) {
        if (key == Key.BACKSPACE && !text.isEmpty()) {
            text = text.substring(0, text.offsetByCodePoints(text.length(), -1));
        } else if (key == Key.ENTER || key == Key.TAB) {
            end();
        }
    }

    /** Ends typing and passes the text to its field. */
    public void end() {
        Consumer<String> commit = done;
        String typed = text;
        cancel();
        commit.accept(typed);
    }

    /** Ends typing and discards the text. */
    public void cancel() {
        field = "";
        text = "";
        done = NOWHERE;
    }
}
