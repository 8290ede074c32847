package rigibo.frontend.puzzle.level;

import java.util.Locale;
import java.util.Map;

/**
 * A text in several languages.
 *
 * @param byLanguage by language tag; always holds English
 */
public record Wording(Map<String, String> byLanguage) {

    public Wording {
        byLanguage = Map.copyOf(byLanguage);
    }

    /** The text in a language; English if it has none. */
    public String in(Locale locale) {
        String english = byLanguage.getOrDefault("en", "");
        String language = byLanguage.getOrDefault(locale.getLanguage(), english);
        return byLanguage.getOrDefault(locale.toLanguageTag(), language);
    }
}
