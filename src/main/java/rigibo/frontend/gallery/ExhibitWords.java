package rigibo.frontend.gallery;

import rigibo.frontend.scene.Bundles;
import rigibo.frontend.scene.Words;

import java.util.MissingResourceException;
import java.util.ResourceBundle;

/**
 * The titles and sentences of exhibits and sections, from files beside the exhibits; an exhibit
 * without them is called by its class.
 */
public final class ExhibitWords {

    private static final String BUNDLE = "rigibo.gallery";

    private final Words words;

    /** The words of a language. */
    public ExhibitWords(Words words) {
        this.words = words;
    }

    /** Its name. */
    public String title(Found found) {
        return find(found.name(), found.type().getSimpleName());
    }

    /** A sentence about what there is to see; empty if there is none. */
    public String about(Found found) {
        return find(found.name() + ".words", "");
    }

    /** Name of a section. */
    public String section(String section) {
        return find("section." + section, section);
    }

    private String find(String key, String otherwise) {
        try {
            ResourceBundle bundle = Bundles.of(BUNDLE, words.locale());
            return bundle.containsKey(key) ? bundle.getString(key) : otherwise;
        } catch (MissingResourceException e) {
            // No bundle at all: exhibits that a stranger put on the class path.
            return otherwise;
        }
    }
}
