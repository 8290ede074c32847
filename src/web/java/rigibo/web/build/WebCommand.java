package rigibo.web.build;

import org.teavm.tooling.TeaVMToolException;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

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
        List<PageReader> browsers = new ArrayList<>();
        Browser.find().ifPresentOrElse(browsers::add, () -> tellMissing("Chromium"));
        Firefox.find().ifPresentOrElse(browsers::add, () -> tellMissing("Firefox"));
        if (browsers.isEmpty()) {
            System.out.println("There is no Chromium and no Firefox here: nothing is compared.");
            return true;
        }
        Path runs = Recorded.runs();
        new PageBuild(folder).buildBits(runs);
        BitsCheck check = BitsCheck.of(runs);
        boolean areAlike = true;
        for (PageReader browser : browsers) {
            areAlike &= check.compare(browser, folder);
        }
        return areAlike;
    }

    private static void tellMissing(String browser) {
        System.out.println(browser + " is not here: nothing is compared there.");
    }
}
