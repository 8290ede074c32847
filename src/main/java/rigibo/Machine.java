package rigibo;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** What a figure was measured on. */
final class Machine {

    private static final Path LINUX_PROCESSORS = Path.of("/proc/cpuinfo");

    private Machine() {}

    /** Processor, how many of them, operating system and Java, in one phrase. */
    static String words() {
        return String.join(
                ", ",
                List.of(
                        Runtime.getRuntime().availableProcessors() + " × " + processor(),
                        System.getProperty("os.name") + " " + System.getProperty("os.arch"),
                        "Java " + Runtime.version().feature()));
    }

    /** The processor's own name where the system tells it. */
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
