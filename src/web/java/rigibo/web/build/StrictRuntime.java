package rigibo.web.build;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * TeaVM's runtime with other code in the place where it makes functions of texts, so that the page
 * needs no {@code unsafe-eval}.
 */
final class StrictRuntime {

    /** A part: from a line that begins something to the brace that ends it. */
    private static final Pattern PART = Pattern.compile("(?ms)^(\\w[^\n]*\\{)\n.*?^}");

    private static final Pattern FROM_TEXT = Pattern.compile("new Function|\\beval\\(");

    private StrictRuntime() {}

    static void write(Path file) throws IOException {
        String runtime = read("/org/teavm/backend/wasm/wasm-gc-runtime.js");
        Matcher part = PART.matcher(read("/web/runtime.js"));
        while (part.find()) {
            runtime = replaced(runtime, part.group(1), part.group());
        }
        if (FROM_TEXT.matcher(runtime).find()) {
            throw new IOException("TeaVM's runtime makes functions of texts in further places");
        }
        Files.writeString(file, runtime);
    }

    private static String replaced(String runtime, String head, String part) throws IOException {
        int from = runtime.indexOf(head);
        if (from < 0 || runtime.indexOf(head, from + 1) >= 0) {
            throw new IOException("TeaVM's runtime does not have once: " + head);
        }
        return runtime.substring(0, from)
                + part
                + runtime.substring(end(runtime, from + head.length()));
    }

    /** Index after the closing brace of a part; braces in texts come in pairs. */
    private static int end(String runtime, int from) {
        int open = 1;
        int at = from;
        while (open > 0) {
            char here = runtime.charAt(at);
            open += here == '{' ? 1 : here == '}' ? -1 : 0;
            at++;
        }
        return at;
    }

    private static String read(String resource) throws IOException {
        try (InputStream from = StrictRuntime.class.getResourceAsStream(resource)) {
            return new String(from.readAllBytes(), StandardCharsets.UTF_8);
        }
    }
}
