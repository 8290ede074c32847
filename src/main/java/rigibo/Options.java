package rigibo;

import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;

import java.util.Collection;
import java.util.List;

/** Tells what is wrong with the value of a command's option, in the same words everywhere. */
final class Options {

    private Options() {}

    /** A value that is refused, and why. */
    static ParameterException refused(CommandSpec spec, String option, String why) {
        return new ParameterException(
                spec.commandLine(), "Invalid value for '" + option + "': " + why);
    }

    /**
     * Names of which each has to be one of those there are.
     *
     * @throws ParameterException naming the option and the first name that there is not
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
}
