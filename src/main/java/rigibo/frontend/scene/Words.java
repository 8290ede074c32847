package rigibo.frontend.scene;

import java.text.MessageFormat;
import java.util.Locale;
import java.util.Map;
import java.util.ResourceBundle;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The game's texts in one language, by keys, from {@code rigibo/words.properties}. A text says
 * {@code <restart>} where it names the key of an action.
 */
public final class Words {

    private static final String BUNDLE = "rigibo.words";

    private static final Pattern ACTION = Pattern.compile("<([a-z]+)>");

    private final Locale locale;
    private final ResourceBundle bundle;
    private final KeyBindings bindings;

    /** Texts without places for values, which every picture asks for again. */
    private final Map<String, String> plain = new ConcurrentHashMap<>();

    /**
     * The words of a language, with the keys as they are at first.
     *
     * @param language one of {@link Settings#LANGUAGES}
     */
    public Words(String language) {
        this(language, KeyBindings.FIRST);
    }

    /** The words of a player's language, with the keys that were chosen. */
    public Words(Settings settings) {
        this(settings.language(), settings.keys());
    }

    private Words(String language, KeyBindings bindings) {
        this.bindings = bindings;
        locale = Locale.forLanguageTag(language);
        bundle = Bundles.of(BUNDLE, locale);
    }

    /**
     * The words of a key, with {0}, {1} … replaced.
     *
     * @throws java.util.MissingResourceException when no language has the key
     */
    public String of(String key, Object... values) {
        if (values.length > 0) {
            return written(key, values);
        }
        // Not computeIfAbsent: a text may name a key, whose name is a text.
        String known = plain.get(key);
        if (known == null) {
            known = written(key);
            plain.put(key, known);
        }
        return known;
    }

    private String written(String key, Object... values) {
        return new MessageFormat(withKeys(bundle.getString(key)), locale).format(values);
    }

    private String withKeys(String text) {
        return ACTION.matcher(text)
                .replaceAll(found -> Matcher.quoteReplacement(nameOfKey(found.group(1))));
    }

    private String nameOfKey(String action) {
        return of(bindings.of(Action.valueOf(action.toUpperCase(Locale.ROOT))));
    }

    /** The name of a key. */
    public String of(Key key) {
        boolean isLetter = key.compareTo(Key.A) >= 0 && key.compareTo(Key.Z) <= 0;
        return isLetter ? key.name() : of("key." + key.name().toLowerCase(Locale.ROOT));
    }

    /**
     * A number in the language's notation, with its decimal mark.
     *
     * @param format as of {@link java.util.Formatter}, such as {@code %.2f m}
     */
    public String number(String format, double value) {
        return String.format(locale, format, value);
    }

    /** The language, for numbers and for the texts that levels bring. */
    public Locale locale() {
        return locale;
    }
}
