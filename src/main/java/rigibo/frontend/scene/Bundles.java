package rigibo.frontend.scene;

import java.util.Locale;
import java.util.ResourceBundle;

/** Texts by keys, from properties files on the class path. */
public final class Bundles {

    private Bundles() {}

    /**
     * The texts in a language; where it has none, those without a language, whatever the system's.
     *
     * @param name such as {@code rigibo.words}
     * @throws java.util.MissingResourceException when there are none at all
     */
    public static ResourceBundle of(String name, Locale language) {
        return ResourceBundle.getBundle(
                name,
                language,
                ResourceBundle.Control.getNoFallbackControl(ResourceBundle.Control.FORMAT_DEFAULT));
    }
}
