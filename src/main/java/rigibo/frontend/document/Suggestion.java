package rigibo.frontend.document;

import java.util.Collection;
import java.util.Locale;
import java.util.stream.Collectors;

/** Suggests the known word nearest to an unknown one. */
public final class Suggestion {

    private Suggestion() {}

    /** Returns {@code , did you mean "legL"?}, or nothing if no known word is near. */
    public static String among(Collection<String> known, String word) {
        // Largest share of wrong letters in a slip; with more it is another word.
        int most = Math.max(1, (word.length() + 1) / 3);
        String meant = word.toLowerCase(Locale.ROOT);
        String nearest = "";
        int least = most + 1;
        for (String candidate : known) {
            if (Math.abs(candidate.length() - word.length()) < least) {
                int distance = distance(candidate.toLowerCase(Locale.ROOT), meant);
                nearest = distance < least ? candidate : nearest;
                least = Math.min(least, distance);
            }
        }
        return nearest.isEmpty() ? "" : ", did you mean \"" + nearest + "\"?";
    }

    /** Lists the known words, for messages. */
    public static String list(Collection<String> known) {
        return known.stream().collect(Collectors.joining(", "));
    }

    /** Levenshtein's distance. */
    private static int distance(String a, String b) {
        int[] row = new int[b.length() + 1];
        for (int j = 0; j <= b.length(); j++) {
            row[j] = j;
        }
        for (int i = 1; i <= a.length(); i++) {
            int diagonal = row[0];
            row[0] = i;
            for (int j = 1; j <= b.length(); j++) {
                int swap = diagonal + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
                diagonal = row[j];
                row[j] = Math.min(swap, 1 + Math.min(row[j], row[j - 1]));
            }
        }
        return row[b.length()];
    }
}
