package rigibo.web.build;

import rigibo.web.Bits;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;

/** Compares what programs come to in a browser with what they come to on the JVM. */
final class BitsCheck {

    private final List<String> here;

    private BitsCheck(List<String> here) {
        this.here = here;
    }

    /** Runs the programs on the JVM, and recorded runs of a folder. */
    static BitsCheck of(Path runs) throws IOException {
        return new BitsCheck(lines(onJvm(runs)));
    }

    /** Says how many are alike in a browser, and the first that is not; returns whether all are. */
    boolean compare(PageReader browser, Path folder) throws IOException, InterruptedException {
        List<String> there;
        try (LocalServer server = new LocalServer(folder, 0)) {
            there = lines(browser.read(server, "bits.html"));
        }
        long alike = here.stream().filter(there::contains).count();
        System.out.printf(
                "%d of %d programs and runs have the bits of the JVM in %s%n",
                alike, here.size(), browser);
        here.stream()
                .filter(line -> !there.contains(line))
                .findFirst()
                .ifPresent(
                        line -> System.out.println("the first that has not, on the JVM: " + line));
        return alike == here.size();
    }

    private static String onJvm(Path runs) throws IOException {
        PrintStream console = System.out;
        ByteArrayOutputStream written = new ByteArrayOutputStream();
        System.setOut(new PrintStream(written, true, StandardCharsets.UTF_8));
        try {
            Bits.print(runs);
        } finally {
            System.setOut(console);
        }
        return written.toString(StandardCharsets.UTF_8);
    }

    private static List<String> lines(String text) {
        return text.replaceAll("<[^>]*>", "")
                .lines()
                .filter(line -> line.startsWith(Bits.MARK))
                .collect(Collectors.toList());
    }
}
