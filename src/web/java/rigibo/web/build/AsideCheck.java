package rigibo.web.build;

import rigibo.frontend.puzzle.generate.Generated;
import rigibo.frontend.puzzle.generate.Generator;

import java.io.IOException;

/** Has a page make a level on a thread beside its own, and compares it with the JVM's. */
final class AsideCheck {

    /** A seed whose level takes few games. */
    private static final long SEED = 20_261_132;

    private static final String MAKING =
            "new Promise(made => { const aside = new Worker('aside.js'); aside.onmessage = said =>"
                    + " { if (said.data[0] !== 'effort') { made(said.data[0] + ' ' + said.data[1] +"
                    + " ' ' + said.data[2].length); } }; aside.onerror = problem =>"
                    + " made(problem.message); aside.postMessage(['making', '"
                    + SEED
                    + "']); })";

    private AsideCheck() {}

    /** Makes the level and prints the result; returns whether the level is the JVM's. */
    static boolean isMade(DevTools page) throws IOException, InterruptedException {
        Generated here = new Generator().level(SEED).orElseThrow();
        String wanted = "made " + SEED + " " + here.text().length();
        String there = page.value(MAKING);
        System.out.println("beside the page: " + there);
        return there.equals(wanted);
    }
}
