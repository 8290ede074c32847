package rigibo;

import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;

import java.nio.file.Files;
import java.nio.file.Path;

/** Checks of where a command is to write, made before its work, which may take hours. */
final class Destination {

    private Destination() {}

    /**
     * Checks that a file can be written in an existing directory.
     *
     * @param file null if none was asked for
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
     * Checks that a path is a directory or does not exist.
     *
     * @throws ParameterException naming option and path
     */
    static void requireDirectory(CommandSpec spec, String option, Path path) {
        if (Files.exists(path) && !Files.isDirectory(path)) {
            throw Options.refused(spec, option, path + " is not a directory");
        }
    }
}
