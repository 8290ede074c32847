package rigibo;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** The machine and the commit that a figure was measured on. */
final class Machine {

    private static final Path LINUX_PROCESSORS = Path.of("/proc/cpuinfo");

    private Machine() {}

    /** Number and name of the processors, operating system and Java, in one phrase. */
    static String words() {
        return String.join(
                ", ",
                List.of(
                        Runtime.getRuntime().availableProcessors() + " × " + processor(),
                        System.getProperty("os.name") + " " + System.getProperty("os.arch"),
                        "Java " + Runtime.version().feature()));
    }

    /** Name and version of the virtual machine. */
    static String jvm() {
        return System.getProperty("java.vm.name") + " " + Runtime.version();
    }

    /**
     * The commit that is run, followed by "with changes" if files differ from it; "unknown" outside
     * a repository.
     */
    static String commit() {
        String commit = git("rev-parse", "--short=10", "HEAD");
        boolean isChanged = !git("status", "--porcelain", "--untracked-files=no").isEmpty();
        return commit.isEmpty() ? "unknown" : commit + (isChanged ? " with changes" : "");
    }

    private static String git(String... words) {
        List<String> command =
                new ArrayList<>(List.of("git", "-C", System.getProperty("rigibo.home", ".")));
        command.addAll(List.of(words));
        try {
            Process git = new ProcessBuilder(command).start();
            String said = new String(git.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            return git.waitFor() == 0 ? said.strip() : "";
        } catch (IOException missing) {
            return "";
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
            return "";
        }
    }

    /** The processor's name; "processor" where the system does not tell it. */
    private static String processor() {
        try (Stream<String> lines = Files.lines(LINUX_PROCESSORS)) {
            Optional<String> name =
                    lines.filter(line -> line.startsWith("model name"))
                            .map(line -> line.substring(line.indexOf(':') + 1).strip())
                            .findFirst();
            return name.orElse("processor");
        } catch (IOException none) {
            return "processor";
        }
    }
}
