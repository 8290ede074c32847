package rigibo.frontend.scene.effects;

import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Switches one effect of a set: off if it is declared, otherwise on.
 *
 * @param effects the resulting set; none if another effect needs this one, or this one another
 * @param lack which effect then needs which
 */
record Switching(Optional<Effects> effects, Optional<Lack> lack) {

    /** How the engine tells it, by the names of its classes. */
    private static final Pattern NEEDS = Pattern.compile("(\\w+) needs (\\w+(?: or \\w+)*), .*");

    /**
     * An effect lacks another.
     *
     * @param needing the title of the one
     * @param needed the titles of the others, any of which would do
     */
    record Lack(String needing, List<String> needed) {

        private static Lack of(String message) {
            Matcher matcher = NEEDS.matcher(message);
            if (!matcher.matches()) {
                throw new IllegalArgumentException("not about a lack: " + message);
            }
            return new Lack(
                    title(matcher.group(1)),
                    Arrays.stream(matcher.group(2).split(" or ")).map(Lack::title).toList());
        }

        private static String title(String name) {
            return name.replaceAll("(?<=[a-z])(?=[A-Z])", "-").toLowerCase(Locale.ROOT);
        }
    }

    static Switching of(Effects now, Effect effect) {
        Class<? extends Effect> kind = effect.getClass();
        try {
            Effects next = now.declares(kind) ? now.without(kind) : now.with(effect);
            return new Switching(Optional.of(next), Optional.empty());
        } catch (IllegalArgumentException needed) {
            return new Switching(Optional.empty(), Optional.of(Lack.of(needed.getMessage())));
        }
    }
}
