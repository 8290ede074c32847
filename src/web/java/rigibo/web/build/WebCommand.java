package rigibo.web.build;

import org.teavm.tooling.TeaVMToolException;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** {@code ./rigibo web}: builds the page; serves it, or compares its bits with the JVM's. */
final class WebCommand {

    private static final int PORT = 8080;

    private WebCommand() {}

    public static void main(String[] arguments) throws Exception {
        Path folder = Path.of(arguments[0]);
        List<String> typed = Arrays.asList(arguments).subList(1, arguments.length);
        if (typed.size() > 1 || !List.of("--serve", "--bits").containsAll(typed)) {
            System.err.println("web takes --serve or --bits, not " + String.join(" ", typed));
            System.exit(2);
        }
        if (typed.contains("--bits")) {
            System.exit(compare(folder) ? 0 : 1);
        }
        new PageBuild(folder).build();
        System.out.println(folder + ": any web server can serve it");
        if (typed.contains("--serve")) {
            System.out.println("Here it is at " + new LocalServer(folder, PORT).address(""));
        }
    }

    private static boolean compare(Path folder)
            throws IOException, InterruptedException, TeaVMToolException {
        Optional<Browser> browser = Browser.find();
        if (browser.isEmpty()) {
            System.out.println("There is no Chromium here: nothing is compared.");
            return true;
        }
        Path runs = Recorded.runs();
        new PageBuild(folder).buildBits(runs);
        return BitsCheck.compare(browser.get(), folder, runs);
    }
}
