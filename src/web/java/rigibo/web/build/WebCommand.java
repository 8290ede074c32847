package rigibo.web.build;

import org.teavm.tooling.TeaVMToolException;

import rigibo.web.Bits;
import rigibo.web.CaseBits;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * {@code ./rigibo web}: builds the page, serves it, compares its bits or times with the JVM's, or
 * plays it like players.
 */
final class WebCommand {

    private static final int PORT = 8080;

    private WebCommand() {}

    public static void main(String[] arguments) throws Exception {
        Path folder = Path.of(arguments[0]);
        List<String> typed = Arrays.asList(arguments).subList(1, arguments.length);
        List<String> known =
                List.of("--serve", "--bits", "--cases", "--times", "--pace", "--check", "--sample");
        if (typed.size() > 1 || !known.containsAll(typed)) {
            System.err.println(
                    "web takes one of "
                            + String.join(" ", known)
                            + ", not "
                            + String.join(" ", typed));
            System.exit(2);
        }
        if (typed.contains("--bits")) {
            System.exit(compare(checks(folder)) ? 0 : 1);
        }
        if (typed.contains("--cases")) {
            System.exit(compareCases(checks(folder)) ? 0 : 1);
        }
        if (typed.contains("--times")) {
            time(checks(folder));
            return;
        }
        if (typed.contains("--pace")) {
            pace(folder);
            return;
        }
        if (typed.contains("--check") || typed.contains("--sample")) {
            System.exit(play(folder, typed.contains("--check")) ? 0 : 1);
        }
        new PageBuild(folder).build();
        System.out.println(folder + ": any web server can serve it");
        if (typed.contains("--serve")) {
            System.out.println("Here it is at " + new LocalServer(folder, PORT).address(""));
        }
    }

    /** Folder of the programs that only checks need, beside the page. */
    private static Path checks(Path folder) {
        return folder.resolveSibling(folder.getFileName() + "-checks");
    }

    /** Plays a newly built page: all levels, in Firefox too, or only the first of each world. */
    private static boolean play(Path folder, boolean isWhole)
            throws IOException, InterruptedException, TeaVMToolException {
        Optional<Browser> browser = Browser.find();
        if (browser.isEmpty()) {
            System.out.println("There is no Chromium here: nothing is played.");
            return true;
        }
        new PageBuild(folder).build();
        PageCheck check = new PageCheck(browser.get(), folder);
        if (!isWhole) {
            return check.isSound(PageCheck.firsts());
        }
        boolean isSound = check.isSound(PageCheck.levels());
        return check.isSoundInFirefox(PageCheck.firsts()) && isSound;
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
        BitsCheck check =
                BitsCheck.of(
                        "programs, proofs and runs",
                        "lines.html?bits",
                        Bits.MARK,
                        () -> Bits.print(runs));
        boolean areAlike = true;
        for (PageReader browser : browsers) {
            areAlike &= check.compare(browser, folder);
        }
        return areAlike;
    }

    private static boolean compareCases(Path folder)
            throws IOException, InterruptedException, TeaVMToolException {
        Optional<Browser> browser = Browser.find();
        if (browser.isEmpty()) {
            tellMissing("Chromium");
            return true;
        }
        new PageBuild(folder).buildCases();
        return BitsCheck.of("hard cases", "lines.html?cases", Bits.MARK, CaseBits::print)
                .compare(browser.get(), folder);
    }

    private static void time(Path folder)
            throws IOException, InterruptedException, TeaVMToolException {
        Optional<Browser> browser = Browser.find();
        if (browser.isEmpty()) {
            tellMissing("Chromium");
            return;
        }
        new PageBuild(folder).buildTimes();
        TimesTable.print(browser.get(), folder);
    }

    private static void pace(Path folder)
            throws IOException, InterruptedException, TeaVMToolException {
        Optional<Browser> browser = Browser.find();
        if (browser.isEmpty()) {
            tellMissing("Chromium");
            return;
        }
        new PageBuild(folder).build();
        PaceTable.print(browser.get(), folder);
    }

    private static void tellMissing(String browser) {
        System.out.println(browser + " is not here: nothing is compared there.");
    }
}
