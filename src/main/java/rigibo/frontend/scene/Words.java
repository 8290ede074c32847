package rigibo.frontend.scene;

import java.text.MessageFormat;
import java.util.Locale;
import java.util.ResourceBundle;

/** The game's texts in one language, by keys, from {@code rigibo/words.properties}. */
public final class Words {

    private static final String BUNDLE = "rigibo.words";

    private final Locale locale;
    private final ResourceBundle bundle;

    /**
     * The words of a language.
     *
     * @param language one of {@link Settings#LANGUAGES}
     */
    public Words(String language) {
        locale = Locale.forLanguageTag(language);
        bundle =
                ResourceBundle.getBundle(
                        BUNDLE,
                        locale,
                        ResourceBundle.Control.getNoFallbackControl(
                                ResourceBundle.Control.FORMAT_DEFAULT));
    }

    /**
     * The words of a key, with {0}, {1} … replaced.
     *
     * @throws java.util.MissingResourceException when no language has the key
     */
    public String of(String key, Object... values) {
        return new MessageFormat(bundle.getString(key), locale).format(values);
    }

    /** The language, for numbers and for the texts that levels bring. */
    public Locale locale() {
        return locale;
    }
}
