package rigibo.examples;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.spi.ToolProvider;

/** A tool of the JDK, called within this process. */
public final class JdkTool {

    /** How a tool ended, and what it printed. */
    public record Said(int status, String words) {}

    private JdkTool() {}

    /** Whether this Java has a tool: one without a compiler has none. */
    public static boolean isThere(String name) {
        return ToolProvider.findFirst(name).isPresent();
    }

    /** Calls a tool. */
    public static Said call(String name, String... arguments) {
        StringWriter words = new StringWriter();
        PrintWriter out = new PrintWriter(words, true);
        int status = ToolProvider.findFirst(name).orElseThrow().run(out, out, arguments);
        return new Said(status, words.toString());
    }
}
