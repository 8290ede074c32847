package rigibo.frontend.editor;

import rigibo.frontend.scene.Words;

import java.io.IOException;

/** The sentence that tells an author what was done last, or what went wrong. */
final class Remark {

    private final Words words;
    private String text = "";

    Remark(Words words) {
        this.words = words;
    }

    /** Empty if there is nothing to tell. */
    String text() {
        return text;
    }

    void clear() {
        text = "";
    }

    /** Says what was done; {@code key} is the last part of the sentence's key. */
    void say(String key, Object... values) {
        text = words.of("editor.say." + key, values);
    }

    /** Says why something cannot be done, how many errors there are, and where they are listed. */
    void sayErrors(String key, int errors, boolean isInHand) {
        say(key, errors, words.of(isInHand ? "editor.listed.hand" : "editor.listed"));
    }

    /** Says what went wrong with a file. */
    void trouble(IOException why) {
        text = Drawer.told(words, why);
    }
}
