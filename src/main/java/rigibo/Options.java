package rigibo;

import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;

import java.util.Collection;
import java.util.List;

/** Checks of options' values; a refusal has the same words in every command. */
final class Options {

    private static final int MINUTES_OF_A_DAY = 24 * 60;

    private Options() {}

    /** The refusal of a value. */
    static ParameterException refused(CommandSpec spec, String option, String why) {
        return new ParameterException(
                spec.commandLine(), "Invalid value for '" + option + "': " + why);
    }

    /**
     * Checks that names are known.
     *
     * @throws ParameterException naming the option and the first unknown name
     */
    static void requireKnown(
            CommandSpec spec, String option, Collection<String> asked, List<String> known) {
        for (String name : asked) {
            if (!known.contains(name)) {
                String there = String.join(", ", known);
                throw refused(spec, option, "there is no '" + name + "'; there are " + there);
            }
        }
    }

    /**
     * Checks that a whole number is within a range.
     *
     * @throws ParameterException naming the option, the range and the value
     */
    static void requireBetween(CommandSpec spec, String option, long value, long least, long most) {
        if (value < least || value > most) {
            throw refused(spec, option, "must be " + least + " to " + most + ", was " + value);
        }
    }

    /**
     * Checks that a time is more than nothing and at most a day.
     *
     * @throws ParameterException naming the option, the range and the value
     */
    static void requireMinutes(CommandSpec spec, String option, double minutes) {
        if (!(minutes > 0 && minutes <= MINUTES_OF_A_DAY)) {
            String range = "must be more than 0 and at most " + MINUTES_OF_A_DAY;
            throw refused(spec, option, range + ", was " + minutes);
        }
    }
}
