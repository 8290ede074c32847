package rigibo.web.build;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;

/** Compares the output of a program in a browser with that on the JVM. */
final class BitsCheck {

    private final String what;
    private final String page;
    private final String mark;
    private final List<String> here;

    private BitsCheck(String what, String page, String mark, List<String> here) {
        this.what = what;
        this.page = page;
        this.mark = mark;
        this.here = here;
    }

    /** A program that prints. */
    interface Printing {
        void print() throws IOException;
    }

    /**
     * Runs a program on the JVM.
     *
     * @param what subject of its lines
     * @param page that runs it in a browser
     * @param mark beginning of its lines
     */
    static BitsCheck of(String what, String page, String mark, Printing program)
            throws IOException {
        return new BitsCheck(what, page, mark, onJvm(program, mark));
    }

    /**
     * Prints how many lines are equal in a browser, and the others; returns whether all are equal.
     */
    boolean compare(PageReader browser, Path folder) throws IOException, InterruptedException {
        List<String> there;
        try (LocalServer server = new LocalServer(folder, 0)) {
            there = lines(browser.read(server, page), mark);
        }
        List<String> other = here.stream().filter(line -> !there.contains(line)).toList();
        System.out.printf(
                "%d of %d %s have the bits of the JVM in %s%n",
                here.size() - other.size(), here.size(), what, browser);
        other.forEach(line -> System.out.println("has not, on the JVM: " + line));
        return other.isEmpty();
    }

    /** The lines that a program prints on the JVM. */
    static List<String> onJvm(Printing program, String mark) throws IOException {
        PrintStream console = System.out;
        ByteArrayOutputStream written = new ByteArrayOutputStream();
        System.setOut(new PrintStream(written, true, StandardCharsets.UTF_8));
        try {
            program.print();
        } finally {
            System.setOut(console);
        }
        return lines(written.toString(StandardCharsets.UTF_8), mark);
    }

    /** The lines of a text that begin with a mark. */
    static List<String> lines(String text, String mark) {
        return text.lines().filter(line -> line.startsWith(mark)).toList();
    }
}
