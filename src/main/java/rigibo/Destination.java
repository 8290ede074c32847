package rigibo;

import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;

import java.nio.file.Files;
import java.nio.file.Path;

/** Where a command is asked to write. It is told at once, not after minutes, that it cannot. */
final class Destination {

    private Destination() {}

    /**
     * A file that need not be there, in a directory that is.
     *
     * @param file null where nothing was asked for
     * @throws ParameterException naming option and file
     */
    static void requireFile(CommandSpec spec, String option, Path file) {
        if (file == null) {
            return;
        }
        Path directory = file.toAbsolutePath().getParent();
        if (directory == null || !Files.isDirectory(directory) || Files.isDirectory(file)) {
            throw Options.refused(spec, option, "cannot write a file at " + file);
        }
    }

    /**
     * A directory, or nothing yet.
     *
     * @throws ParameterException naming option and path
     */
    static void requireDirectory(CommandSpec spec, String option, Path path) {
        if (Files.exists(path) && !Files.isDirectory(path)) {
            throw Options.refused(spec, option, path + " is not a directory");
        }
    }
}
